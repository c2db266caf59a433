"""Files that a command reads are never replaced, nor what is no file, and what cannot be written is told
before anything runs: output_file.py WEAVEFRONT SCENE"""

import os
import stat
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
        (Path(folder) / "target.csv").write_text("of somebody else")
        (Path(folder) / "link.csv").symlink_to("target.csv")
        os.mkfifo(Path(folder) / "fifo")
        # As root the program could replace one of the system's.
        null = Path(folder) / "null" if os.geteuid() == 0 else Path("/dev/null")
        if os.geteuid() == 0:
            os.mknod(null, 0o600 | stat.S_IFCHR, os.makedev(1, 3))
        texts = {file: file.read_text() for file in (scene, path, Path(folder) / "target.csv")}
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
        for arguments in (
            ("yarn", scene, *rates),
            ("cell", scene, "--path", path),
            ("partition", scene, *ranks),
        ):
            status, told = call(program, *arguments, "--out", missing)
            assert status == 3 and "table.csv cannot be written: No such file or directory" in told, arguments
            for out, kind in (
                (folder, "folder"),
                (null, "device"),
                (Path(folder) / "link.csv", "link"),
                (Path(folder) / "fifo", "FIFO"),
            ):
                status, told = call(program, *arguments, "--out", out)
                assert (
                    status == 3
                    and f"{out} cannot be written: it is a {kind}, allowed is a regular file or none" in told
                ), arguments
        assert null.is_char_device() and (Path(folder) / "fifo").is_fifo()
        assert all(file.read_text() == text for file, text in texts.items())
        assert {file.name for file in Path(folder).iterdir()} == {
            "scene.yaml",
            "path.csv",
            "target.csv",
            "link.csv",
            "fifo",
        } | {null.name for _ in [0] if null.parent == Path(folder)}


main()
