"""What is allowed but hardly meant draws one warning of `check`, in the units of the scene, and the same of
`run`: warnings.py WEAVEFRONT"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

SCENE = """
title: Two plies and a sphere
fabrics:
  kevlar129:
    areal_density: 204 g/m^2
    density: 1440 kg/m^3
    yarn: {span: 0.909 mm, area: 6.48e-2 mm^2, width: 0.32 mm}
    thickness: 0.500 mm
    contact_thickness: 0.1417 mm
    elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa, viscosity: 35 MPa s}
    failure: {static_strain: 3.3 %, hooke_strain: 2.7 %}
    transverse_shear: 2.5 GPa
target:
  size: [100 mm, 100 mm]
  plies: {count: 2, fabric: kevlar129, spacing: 0.25 mm}
  mesh: {center: 1 mm, edge: 3 mm}
projectile: {shape: sphere, diameter: 6 mm, mass: 0.9 g, velocity: [0, 0, 200 m/s]}
contact: {projectile: {}, plies: {}}
time: {end: 60 us}
output: {interval: 5 us, history: 0.5 us}
"""
FABRIC = "fabrics.kevlar129."
BALL = "{shape: sphere, diameter: 6 mm, mass: 0.9 g, velocity: [0, 0, 200 m/s]}"
CYLINDER = ["projectile.shape=cylinder"]
FRAME = ["target.edges.x=frame", "target.frame={opening: {x: 40 mm}}"]

# Overrides of the scene, and the warnings that they draw: one, or more where several things are wrong. # is
# any number.
WARNINGS = [
    # weave
    (
        [FABRIC + "yarn.area=6.48 mm^2"],
        "fabric kevlar129: yarns of 6.48 mm^2 every 0.909 mm in two directions weigh 2.053e+04 g/m^2 at 1440 kg/m^3, but the areal density is 204 "
        "g/m^2",
        "fabric kevlar129: yarns of 6.48 mm^2 that are 0.32 mm wide would be 20.25 mm high",
    ),
    (
        [FABRIC + "areal_density=204 kg/m^2", FABRIC + "contact_thickness=0.14 mm", "output.history=1 us"],
        "fabric kevlar129: yarns of 0.0648 mm^2 every 0.909 mm in two directions weigh 0.2053 kg/m^2 at 1440 kg/m^3, but the areal density is "
        "204 kg/m^2",
    ),
    (
        [FABRIC + "thickness=0.82 mm"],
        "fabric kevlar129: with a thickness of 0.82 mm yarns are 9.7 % longer than the cell, plain weaves have 1 to 4 %: this thickness is "
        "more than that of the fabric, and stands for other slack, too",
    ),
    ([FABRIC + "thickness=0.82 m"], "fabric kevlar129: its yarns rise and fall by 820 mm every 0.909 mm"),
    (
        [FABRIC + "thickness=0.82 um"],
        "fabric kevlar129: a thickness of 0.00082 mm lets yarns cross that are 0.2025 mm high (area over width)",
    ),
    (
        [FABRIC + "yarn.width=0.32 um"],
        "fabric kevlar129: yarns of 0.0648 mm^2 that are 0.00032 mm wide would be 202.5 mm high",
    ),
    (
        [FABRIC + "contact_thickness=2 mm", "target.plies.spacing=2 mm"],
        "fabric kevlar129: plies touch at a distance of 2 mm (contact_thickness), more than two spans of 0.909 mm",
    ),
    # material
    (
        [FABRIC + "elastic.static_modulus=96 MPa"],
        "fabric kevlar129: static_modulus is 96 MPa, fibres have 1000 MPa to 1e+06 MPa",
    ),
    (
        [FABRIC + "elastic.hooke_modulus=192 TPa"],
        "fabric kevlar129: hooke_modulus is 1.92e+05 GPa, diamond has 1220 GPa",
    ),
    (
        [FABRIC + "transverse_shear=2.5 TPa"],
        "fabric kevlar129: transverse_shear is 2500 GPa, more than the 96 GPa of the yarns along their axis",
    ),
    (
        [FABRIC + "lateral={modulus: 7.4 TPa, shear_modulus: 2.5 GPa, transition: 3 deg}"],
        "fabric kevlar129: lateral.modulus is 7400 GPa, more than the 96 GPa of the yarns along their axis",
    ),
    (
        [FABRIC + "lateral={modulus: 7.4 GPa, shear_modulus: 2.5 TPa, transition: 3 deg}"],
        "fabric kevlar129: lateral.shear_modulus is 2500 GPa, more than the 96 GPa of the yarns along their axis",
    ),
    (
        [FABRIC + "elastic.viscosity=35 mPa s"],
        "fabric kevlar129: a viscosity of 35 mPa s relaxes in 9.115e-08 us and the run takes 60 us: yarns have no more than their static "
        "modulus",
    ),
    (
        [FABRIC + "elastic.viscosity=35 PPa s"],
        "fabric kevlar129: a viscosity of 35 PPa s relaxes in 9.115e+10 us and the run takes 60 us: "
        "yarns do not relax from their Hooke modulus",
    ),
    (
        [FABRIC + "failure.static_strain=0.033 %"],
        "fabric kevlar129: static_strain is 0.033 %, fibres break at 0.3 to 30 %",
    ),
    (
        [FABRIC + "failure.static_strain=33 %"],
        "fabric kevlar129: static_strain is 33 %, fibres break at 0.3 to 30 %",
    ),
    (
        [FABRIC + "failure.hooke_strain=0.027 %"],
        "fabric kevlar129: hooke_strain is 0.027 %, fibres break at 0.3 to 30 %",
    ),
    (
        [FABRIC + "elastic.viscosity=0", FABRIC + "failure.hooke_strain=1.2 %"],
        "fabric kevlar129: without viscosity yarns break at 2.4 %, which hooke_strain decides (hooke_strain times hooke_modulus over "
        "static_modulus), before the static_strain of 3.3 %",
    ),
    (
        [
            FABRIC + "density=1.44 kg/m^3",
            FABRIC + "areal_density=0.2 g/m^2",
            FABRIC + "contact_thickness=0.14 mm",
        ],
        "fabric kevlar129: the density is 1.44 kg/m^3, fibres have 800 kg/m^3 to 9000 kg/m^3",
    ),
    ([FABRIC + "friction=20"], "fabric kevlar129: friction is 20, yarns on yarns have 0.1 to 0.4"),
    ([FABRIC + "hourglass=5"], "fabric kevlar129: hourglass is 5, full integration has 1"),
    # target
    (
        ["target.size=[100 m, 100 mm]", "target.mesh.edge=100 mm", "contact.spacing=1 mm"],
        "the target is 1e+05 mm wide, and the wave in its yarns goes 347.5 mm until the end",
    ),
    (
        ["target.plies.spacing=0.25 m"],
        "between ply 1 and ply 2 there are 249.9 mm of air, and the projectile goes 12 mm until the end",
    ),
    (
        ["target.plies.spacing=1e297 m"],
        "between ply 1 and ply 2 there are 1e+300 mm of air, and the projectile goes 12 mm until the end",
    ),
    (
        ["target.mesh.growth=1000"],
        "elements grow by 1000 from one to the next, usual are 1.05 to 1.3; above 3 they grow by 3",
    ),
    (
        ["target.mesh={center: 0.001 mm, edge: 3 mm, growth: 1.3}"],
        "elements grow from 0.001 mm to 3 mm: the smallest set the step, the largest see no wave of theirs",
    ),
    (
        [*FRAME, "target.frame.edge_radius=1000 m"],
        "the bars of the frame are rounded with 1e+06 mm along x, where the fabric lies on 30 mm of them: nowhere flat",
    ),
    (
        [*FRAME, "target.frame.opening.x=4 mm"],
        "the frame's opening is 4 mm along x, less than the 6 mm of the projectile",
    ),
    # projectile
    (
        ["projectile.mass=0.9 kg"],
        "the projectile weighs 7.958e+06 kg/m^3 at its size (0.9 kg), materials 450 kg/m^3 to 22600 kg/m^3",
    ),
    (
        ["projectile.mass=0.9 mg"],
        "the projectile weighs 7.958 kg/m^3 at its size (0.9 mg), materials 450 kg/m^3 to 22600 kg/m^3",
    ),
    (
        ["projectile.mass=1e300 g"],
        "the projectile weighs 8.842e+303 kg/m^3 at its size (1e+300 g), materials 450 kg/m^3 to 22600 kg/m^3",
    ),
    (
        [*CYLINDER, "projectile.length=10 km"],
        "the projectile is 1e+07 mm long and 6 mm wide: by its mass of 0.9 g, unless its length is given",
    ),
    (
        [*CYLINDER, "projectile.mass=0.9 kg"],
        "the projectile is 4055 mm long and 6 mm wide: by its mass of 0.9 kg, unless its length is given",
    ),
    (
        [*CYLINDER, "projectile.velocity=[100 m/s, 0, 173.2 m/s]"],
        "the cylinder flies at 30 deg to its axis, which stays along z: velocity 100 m/s, 0 m/s, 173.2 m/s",
    ),
    (
        ["projectile.position=[0, 0, -1 m]"],
        "the projectile needs 5000 us to the first ply, the run ends at 60 us",
    ),
    (
        ["projectile.diameter=120 mm", "projectile.mass=7 kg"],
        "the projectile is 120 mm across, the target 100 mm",
    ),
    (
        ["projectile=", f"projectiles=[{BALL}, {BALL}]"],
        "projectiles 1 and 2 start 3 mm inside each other, and contact between projectiles is not computed: give them "
        "other positions, or a delay",
    ),
    (
        ["projectile.position=[48 mm, 0, -0.1 mm]"],
        "the projectile meets the target at x = 48 mm, its side 1 mm beyond the edge",
    ),
    (
        [
            "projectile.position=[0, 0, -10 mm]",
            "projectile.velocity=[0, -200 m/s, 40 m/s]",
            "time.end=300 us",
            "target.mesh.edge=1 mm",
        ],
        "the projectile meets the target at y = -49.65 mm, its side 2.646 mm beyond the edge",
    ),
    (
        [*FRAME, "projectile.position=[18 mm, 0, -0.1 mm]"],
        "on its way the projectile meets a bar of the frame: it is 6 mm wide and would pass at x = 18 mm, the opening ends "
        "at 20 mm",
    ),
    (
        [
            *FRAME,
            "projectile.position=[0, 0, -10 mm]",
            "projectile.velocity=[200 m/s, 0, 100 m/s]",
            "time.end=120 us",
            "target.mesh.edge=1 mm",
        ],
        "on its way the projectile meets a bar of the frame: it is 6 mm wide and would pass at x = 20.64 mm, the opening ends "
        "at 20 mm",
    ),
    # contact
    (
        ["contact.projectile.stiffness=5600 N/m^3"],
        "contact.projectile.stiffness of 5600 N/m^3 is too soft: at 200 m/s the projectile goes 1203 mm into a ply of 0.1417 mm",
    ),
    (
        ["contact.plies.stiffness=1.1e4 N/m^3"],
        "contact.plies.stiffness of 1.1e+04 N/m^3 is too soft: at 200 m/s a struck ply goes 609 mm into a ply of 0.1417 mm",
    ),
    (
        [*FRAME, "contact.frame.stiffness=5600 N/m^3"],
        "contact.frame.stiffness of 5600 N/m^3 is too soft: fabric about to break goes 4.033e+07 mm into the bars, a ply is 0.1417 mm",
    ),
    (
        ["contact.plies.friction={static: 20, kinetic: 0.2}"],
        "contact.plies.friction is 20: coefficients of fabric are some tenths",
    ),
    (["contact.spacing=1 km"], "contact.spacing is 1e+06 mm, more than the 6 mm of the projectile"),
    (
        ["projectile.diameter=1 mm", "projectile.mass=4.11 mg"],
        "the projectile is 1 mm across where it meets elements of 0.9775 mm with contact points 0.06109 mm apart: with fewer than three across it "
        "may pass between them",
    ),
    (
        ["projectile.diameter=5.38 mm", "target.mesh={center: 10 mm, edge: 10 mm}", "contact.spacing=nodes"],
        "the projectile is 5.38 mm across where it meets elements of 10 mm with contact points 10 mm apart: with fewer than three across it may "
        "pass between them",
    ),
    (
        ["projectile.velocity.2=26700 m/s"],
        "the projectile goes # mm in a step, more than the 0.1417 mm that a ply is thick: it will pass through unseen",
    ),
    # controls
    (["time.end=60 ms"], "the run ends at 60 ms; the projectile's speed crosses the target in 0.5 ms"),
    (
        ["time.end=0.5 us", "output.interval=0"],
        "the run ends at 0.5 us, when the wave in the yarns has gone 2.896 mm, less than the projectile is wide",
    ),
    (
        ["time.end=10 ns", "output.interval=0", "output.history=10 ns"],
        "the run ends at 10 ns, within its first step of # ns",
    ),
    (["damping=1e9 1/s"], "damping of 1e+09 1/s slows everything 6e+04 times over e-fold until the end"),
    (
        ["limits.energy_error=5"],
        "limits.energy_error is 500 %: the guard lets all energy be lost and never stops the run",
    ),
    (
        ["limits.energy_error=1"],
        "limits.energy_error is 100 %: the guard lets all energy be lost and never stops the run",
    ),
    (
        ["output.history=0.5 ns"],
        "output.history is 0.0005 us, less than the step of # us: there is one row a step at the most",
    ),
    (
        ["output.interval=0.5 ns"],
        "output.interval is 0.0005 us, less than the step of # us: there is one frame a step at the most",
    ),
    (
        ["time.safety=1.2"],
        "time.safety is 1.2: the step is longer than its bound, and the run may become unstable",
    ),
    (
        ["time.safety=1e-6", "output.history=60 us"],
        "time.safety is 1e-06: the run takes 9e+05 times the steps of the default and is no better for it",
    ),
]


def overrides(settings):
    return [word for setting in settings for word in ("--set", setting)]


def check(program, scene, settings):
    done = subprocess.run(
        [program, "check", scene, *overrides(settings)], capture_output=True, text=True, timeout=60
    )
    assert done.returncode == 0, (settings, done)
    return done.stdout


def warned(text):
    return [line.removeprefix("warning: ") for line in text.splitlines() if line.startswith("warning: ")]


def agree(found, phrases):
    patterns = [re.escape(phrase).replace(r"\#", r"[-+.e\d]+") for phrase in phrases]
    return len(found) == len(patterns) and all(
        re.fullmatch(pattern, line) for pattern, line in zip(patterns, found)
    )


def check_run(program, scene, folder):
    """What check warns of a run says at its start, on standard error and in run.log."""
    settings = [
        "limits.energy_error=5",
        "damping=1e9 1/s",
        "target.mesh.center=3 mm",
        "time.end=2 us",
        "output.interval=0",
    ]
    expected = warned(check(program, scene, settings))
    assert len(expected) == 3, expected
    done = subprocess.run(
        [program, "run", scene, "--output", f"{folder}/out", *overrides(settings)],
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0 and warned(done.stderr)[:3] == expected, done
    assert warned(Path(folder, "out", "run.log").read_text())[:3] == expected


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        scene = str(Path(folder) / "scene.yaml")
        Path(scene).write_text(SCENE)
        plain = check(program, scene, [])
        assert not warned(plain) and plain.startswith(f"{scene}: nothing to object to\n"), plain
        for settings, *phrases in WARNINGS:
            text = check(program, scene, settings)
            assert agree(warned(text), phrases), (settings, warned(text))
            assert f": valid, with {len(phrases)} warning" in text, text
        check_run(program, scene, folder)


main()
