"""Files that a command reads are never replaced, and what cannot be written is told before anything runs: output_file.py WEAVEFRONT SCENE"""

import subprocess
import sys
import tempfile
from pathlib import Path


def call(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=60)
    print(done.returncode, done.stderr.strip())
    return done.returncode, done.stderr


def main():
    program, example = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as folder:
        scene, path = Path(folder) / "scene.yaml", Path(folder) / "path.csv"
        scene.write_text(Path(example).read_text())
        path.write_text("time,F11,F12,F21,F22\n0,1,0,0,1\n1e-6,1.001,0,0,1\n")
        texts = {file: file.read_text() for file in (scene, path)}
        rates, ranks = ("--rates", "1"), ("--ranks", "2")
        same = (
            ("yarn", scene, *rates, "--out", scene),
            ("cell", scene, "--path", path, "--out", scene),
            ("cell", scene, "--path", path, "--out", path),
            ("partition", scene, *ranks, "--out", scene),
            ("partition", scene, "--calibrate", scene),
        )
        for arguments in same:
            status, told = call(program, *arguments)
            assert status == 2 and "which the command reads; allowed another file" in told, arguments
        missing = Path(folder) / "missing" / "table.csv"
        for arguments in (("yarn", scene, *rates), ("cell", scene, "--path", path), ("partition", scene, *ranks)):
            status, told = call(program, *arguments, "--out", missing)
            assert status == 3 and "table.csv cannot be written: No such file or directory" in told, arguments
            status, told = call(program, *arguments, "--out", folder)
            assert status == 3 and "cannot be written: Is a directory" in told, arguments
        assert all(file.read_text() == text for file, text in texts.items())
        assert {file.name for file in Path(folder).iterdir()} == {"scene.yaml", "path.csv"}


main()
