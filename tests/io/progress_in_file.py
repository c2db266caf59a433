"""What mpirun writes to a file has lines only, no progress bar: progress_in_file.py MPIEXEC SHOWER

Open MPI gives its processes a terminal even then."""

import subprocess
import sys
import tempfile


def main():
    mpiexec, shower = sys.argv[1:]
    with tempfile.TemporaryFile() as file:
        subprocess.run([mpiexec, "-n", "1", shower], stdout=file, check=True, timeout=60)
        file.seek(0)
        text = file.read().decode()
    print(text)
    assert "a line in between" in text and "100 %" in text
    assert "\x1b" not in text and "[#" not in text, text


main()
