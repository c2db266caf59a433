"""A perforation of some seconds that has every kind of state, and what its runs are compared by."""

import filecmp
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "command_line"))

from small_run import Program, errors_of, processes_of, summary  # noqa: E402, F401

# Two plies on a frame that a sphere perforates. Yarns break, elements erode, debris flies, plies touch, the frame is touched.
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


def whole_run(program, name="whole", overrides=PERFORATION, ranks=1):
    """The uninterrupted run, with which others are compared."""
    program.run(name, overrides, ranks)
    found = summary(program.folder / name)
    assert found["eroded_elements"] > 0 and found["outcome"]["plies_perforated"] == 2, found
    return program.folder / name


def differences(one, other):
    """Names of the output files that differ in any byte."""
    return [name for name in ("history.csv", "results.vtkhdf") if not filecmp.cmp(one / name, other / name, shallow=False)]


def start(program, output, overrides, ranks, options):
    """Starts a run and returns at once."""
    return subprocess.Popen(program.command(output, overrides, ranks, options), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
