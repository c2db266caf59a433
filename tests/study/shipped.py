"""The quick shipped studies reproduce their committed tables within the tolerances that they state:
shipped.py WEAVEFRONT MPIEXEC

The yarn law is cut to a million steps: the rest of its table takes a minute."""

import subprocess
import sys
import tempfile
from pathlib import Path

STUDIES = Path(__file__).resolve().parents[2] / "examples/studies"


def main():
    weavefront, mpiexec = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)
        folder = scratch / "studies" / "yarn_law"
        folder.mkdir(parents=True)
        (scratch / "yarn_curves").symlink_to(STUDIES.parent / "yarn_curves")
        text = (STUDIES / "yarn_law/study.yaml").read_text()
        shorter = text.replace(", 10000000, 100000000, 1000000000]", "]")
        assert shorter != text
        (folder / "study.yaml").write_text(shorter)
        for name, study in (("cell", STUDIES / "cell/study.yaml"), ("yarn_law", folder / "study.yaml")):
            table = STUDIES / name / "study.csv"
            command = [
                mpiexec,
                "-n",
                "2",
                weavefront,
                "study",
                study,
                "--output",
                scratch / name,
                "--check",
                table,
                "--no-picture",
            ]
            done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
            print(done.stdout, done.stderr)
            assert done.returncode == 0, f"{name}: status {done.returncode}"
            assert "within the study's tolerances" in done.stdout


main()
