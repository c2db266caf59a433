"""The libraries of fabrics and projectiles name their sources, and scenes take from them: fabrics.py
WEAVEFRONT"""

import subprocess
import sys
import tempfile
from pathlib import Path

SCENE = """
fabrics: {vest: {library: NAME}}
target:
  size: [100 mm, 100 mm]
  plies: {count: 4, fabric: vest}
  mesh: {center: 1 mm, edge: 3 mm}
projectile: {shape: sphere, diameter: 5.556 mm, mass: 0.7 g, velocity: [0, 0, 200 m/s]}
contact: {projectile: {}, plies: {}}
time: {end: 20 us}
output: {interval: 5 us, history: 0.5 us}
"""


def call(program, *arguments, status=0):
    done = subprocess.run([program, *arguments], capture_output=True, text=True)
    assert done.returncode == status, (done.args, done.returncode, done.stdout, done.stderr)
    return done.stdout if status == 0 else done.stderr


def names_in(listed):
    return [
        line.split(":")[0]
        for line in listed.splitlines()
        if line and line[0] != " " and not line.startswith("In a scene")
    ]


def check_projectiles(program):
    listed = call(program, "projectiles")
    names = names_in(listed)
    assert "fsp_22" in names and len(names) >= 12, names
    one = call(program, "projectiles", "fsp_22")
    assert (
        one in listed and "  diameter                 0.215 in           [1], quoted from memory" in one
    ), one
    error = call(program, "projectiles", "fsp_2", status=2)
    assert "projectile 'fsp_2': unknown, allowed fsp_22, " in error, error
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.yaml"
        for name in names:
            shot = f"projectile: {{standard: {name}, velocity"
            before = "projectile: {shape: sphere, diameter: 5.556 mm, mass: 0.7 g, velocity"
            text = SCENE.replace("NAME", "kevlar_km2_s706").replace(before, shot)
            assert shot in text
            scene.write_text(text.replace("center: 1 mm", "center: 0.5 mm"))
            checked = call(program, "check", str(scene))
            assert "warning: " not in checked, (name, checked)


def main():
    program = sys.argv[1]
    check_projectiles(program)
    listed = call(program, "fabrics")
    names = names_in(listed)
    assert "kevlar_km2_s706" in names and len(names) >= 6, names
    one = call(program, "fabrics", "kevlar_km2_s706")
    assert (
        one in listed
        and "  yarn.denier              600                [2]\n" in one
        and "quoted from memory with confidence 0.9" in one
    ), one
    error = call(program, "fabrics", "kevlar_km2", status=2)
    assert "fabric 'kevlar_km2': unknown, allowed " in error, error
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.yaml"
        for name in names:
            scene.write_text(SCENE.replace("NAME", name))
            warnings = [
                line
                for line in call(program, "check", str(scene)).splitlines()
                if line.startswith("warning: ")
            ]
            # Only the paper's crimp is no geometry.
            assert len(warnings) == (name == "kevlar129_it04") and all(
                "longer than the cell" in line for line in warnings
            ), (name, warnings)


main()
