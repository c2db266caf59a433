"""A perforation of some seconds that has every kind of state, and what its runs are compared by."""

import filecmp
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "command_line"))

from small_run import (
    KILLED,
    Program,
    errors_of,
    is_open_mpi,
    processes_of,
    statuses_when_signalled,
    summary,
)  # noqa: E402, F401

# Two plies on a frame that a sphere perforates. Yarns break, elements erode, debris flies, plies touch, the
# frame is touched.
PERFORATION = (
    "target.size=[30 mm, 30 mm]",
    "target.symmetry=[]",
    "target.mesh={center: 1 mm, edge: 1 mm}",
    "target.edges={y: frame}",
    "target.frame={opening: {y: 22 mm}}",
    "fabrics.a.failure={static_strain: 2.5 %, hooke_strain: 2 %}",
    "fabrics.a.friction=0.11",
    "fabrics.a.lateral={modulus: 7.4 GPa, shear_modulus: 2.5 GPa, locking_angle: 35 deg, transition: 3 deg}",
    "projectile.velocity=[20 m/s, 0, 600 m/s]",
    "time.end=36 us",
    "output.interval=2 us",
    "output.history=0.2 us",
)

# What the perforation above lacks: the paper's formulation, straight yarns, unequal ones of scattered
# strength, a turned ply, damping, a cylinder, contact at the nodes.
MIXED = (
    "fabrics.b={formulation: paper, areal_density: 150 g/m^2, density: 1440 kg/m^3, thickness: 0.3 mm, friction: 0.11,"
    " yarn: {span: 0.9 mm, area: 0.05 mm^2, width: 0.3 mm},"
    " elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa, viscosity: 35 MPa s},"
    " failure: {static_strain: 2.5 %, hooke_strain: 2 %, erode: any_yarn},"
    " lateral: {modulus: 7.4 GPa, shear_modulus: 2.5 GPa, locking_angle: 35 deg, transition: 3 deg}, transverse_shear: 2.5 GPa}",
    "fabrics.c={areal_density: 150 g/m^2, density: 1440 kg/m^3, thickness: 0,"
    " yarn: {span: 0.9 mm, area: 0.05 mm^2, width: 0.3 mm}, elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa, viscosity: 35 MPa s},"
    " transverse_shear: 2.5 GPa}",
    "fabrics.d={library: kevlar_km2_s706, contact_thickness: 0.2 mm, crimp: {fill: 0.5 %, warp: 2 %},"
    " failure: {strain: 2.5 %, scatter: {weibull_modulus: 10, gauge_length: 1 mm}}}",
    "target.symmetry=[]",
    "target.plies=[{fabric: b}, {fabric: a, angle: 30 deg, spacing: 0.3 mm}, {fabric: c, spacing: 0.3 mm},"
    " {fabric: d, spacing: 0.3 mm}]",
    "target.mesh={center: 1 mm, edge: 2 mm}",
    "projectile={shape: cylinder, diameter: 5 mm, edge_radius: 0.3 mm, mass: 1 g, velocity: [0, 0, 500 m/s]}",
    "contact={spacing: nodes, projectile: {}, plies: {}}",
    "damping=2000 1/s",
    "time.end=16 us",
    "output.interval=2 us",
    "output.history=0.2 us",
)


def whole_run(program, name="whole", overrides=PERFORATION, ranks=1):
    """The uninterrupted run, with which others are compared."""
    program.run(name, overrides, ranks)
    found = summary(program.folder / name)
    assert found["eroded_elements"] > 0 and found["outcome"]["plies_perforated"] > 0, found
    return program.folder / name


def differences(one, other):
    """Names of the output files that differ in any byte."""
    return [
        name
        for name in ("history.csv", "results.vtkhdf")
        if not filecmp.cmp(one / name, other / name, shallow=False)
    ]


def start(program, output, overrides, ranks, options):
    """Starts a run and returns at once."""
    return subprocess.Popen(
        program.command(output, overrides, ranks, options),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
