"""One scene in three systems of units leaves the same files: units.py WEAVEFRONT H5DIFF"""

import subprocess
import sys
import tempfile
from pathlib import Path

import runs

SCENE = """
title: units
fabrics:
  kevlar129:
    areal_density: {areal_density}
    density: {density}
    yarn: {{span: {span}, area: {area}, width: {width}}}
    thickness: {thickness}
    elastic: {{static_modulus: {static_modulus}, hooke_modulus: {hooke_modulus}, viscosity: {viscosity}}}
    failure: {{static_strain: {static_strain}, hooke_strain: 0.027}}
    lateral: {{modulus: {lateral}, shear_modulus: {shear}, locking_angle: {angle}, transition: 3 deg}}
    friction: 0.11
    transverse_shear: {shear}
target:
  size: [{size}, {size}]
  plies: {{count: 2, fabric: kevlar129, spacing: {spacing}}}
  mesh: {{center: {element}}}
projectile: {{shape: sphere, diameter: {diameter}, mass: {mass}, velocity: [0, 0, {velocity}]}}
contact:
  spacing: {points}
  projectile: {{stiffness: {stiffness}}}
  plies: {{stiffness: {stiffness}}}
damping: {damping}
time: {{end: {end}}}
output: {{interval: {interval}, history: {interval}}}
"""
SI = dict(
    areal_density="0.204 kg/m^2",
    density="1440 kg/m^3",
    span="0.000909 m",
    area="6.48e-8 m^2",
    width="0.00032 m",
    thickness="0.0002 m",
    static_modulus="96e9 Pa",
    hooke_modulus="192e9 Pa",
    viscosity="35e6 Pa s",
    static_strain="0.033",
    lateral="7.4e9 Pa",
    shear="2.5e9 Pa",
    angle="35 deg",
    size="0.024 m",
    spacing="0.00025 m",
    element="0.002 m",
    diameter="0.006 m",
    mass="0.0005 kg",
    velocity="400 m/s",
    points="0.0005 m",
    stiffness="5.6e12 N/m^3",
    damping="100 1/s",
    end="1e-5 s",
    interval="1e-6 s",
)
MILLIMETRES = dict(
    areal_density="204e-6 g/mm^2",
    density="1.44e-3 g/mm^3",
    span="0.909 mm",
    area="6.48e-2 mm^2",
    width="0.32 mm",
    thickness="0.2 mm",
    static_modulus="96 kN/mm^2",
    hooke_modulus="192 kN/mm^2",
    viscosity="35 MPa s",
    static_strain="3.3 %",
    lateral="7400 N/mm^2",
    shear="2500 N/mm^2",
    angle="35 deg",
    size="24 mm",
    spacing="0.25 mm",
    element="2 mm",
    diameter="6 mm",
    mass="0.5 g",
    velocity="0.4 mm/us",
    points="0.5 mm",
    stiffness="5600 N/mm^3",
    damping="0.1 1/ms",
    end="10 us",
    interval="1 us",
)
MIXED = dict(
    areal_density="204e6 g/km^2",
    density="1.44e12 kg/km^3",
    span="909000 nm",
    area="64800 um^2",
    width="320 um",
    thickness="2e-7 km",
    static_modulus="0.096 TPa",
    hooke_modulus="192e12 mPa",
    viscosity="0.035 GPa s",
    static_strain="33e-3",
    lateral="7.4 GPa",
    shear="2.5 GPa",
    angle="35 deg",
    size="2.4 cm",
    spacing="250000 nm",
    element="2e-6 km",
    diameter="6000000 nm",
    mass="500 mg",
    velocity="0.4 km/s",
    points="500 um",
    stiffness="5.6 TN/m^3",
    damping="0.1 kHz",
    end="10000 ns",
    interval="1e-3 ms",
)


def main():
    program, h5diff = runs.Program(sys.argv[1]), sys.argv[2]
    with tempfile.TemporaryDirectory() as folder:
        outputs = []
        for name, values in [("si", SI), ("millimetres", MILLIMETRES), ("mixed", MIXED)]:
            scene = Path(folder) / f"{name}.yaml"
            scene.write_text(SCENE.format(**values))
            outputs.append(Path(folder) / name)
            program.run(scene, outputs[-1])
        assert runs.summary(outputs[0])["broken_yarns"] > 0, "the scene is too tame to tell"
        for output in outputs[1:]:
            assert (
                runs.summary(output)["scene_hash"] == runs.summary(outputs[0])["scene_hash"]
            ), f"{output.name}: another scene"
            assert runs.history_bytes(output) == runs.history_bytes(
                outputs[0]
            ), f"{output.name}: history.csv differs"
            # The scene with every default written out stands in the file, too.
            subprocess.run(
                [h5diff, str(outputs[0] / "results.vtkhdf"), str(output / "results.vtkhdf")], check=True
            )


main()
