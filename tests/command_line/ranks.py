"""What one rank meets alone ends all of them with a message: ranks.py WEAVEFRONT MPIEXEC"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

from small_run import Program, errors_of, variable_of_launcher

SECONDS = 20  # for what takes about seven


def call(*command):
    begin = time.monotonic()
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=60)
    assert time.monotonic() - begin < SECONDS, command
    print(done.returncode, errors_of(done.stderr), flush=True)
    return done.returncode, errors_of(done.stderr)


def main():
    weavefront, mpiexec = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        program = Program(weavefront, mpiexec, folder)
        (folder / "other.yaml").write_text((folder / "scene.yaml").read_text())
        run = program.command("out")

        # A rank whose node lacks the database of units, the first or another, or all.
        without = variable_of_launcher(mpiexec, "UDUNITS2_XML_PATH", "/nonexistent")
        cause = "the unit database of udunits2 cannot be read"
        for rank, ranks in (
            (1, ["-n", "1", *run, ":", "-n", "1", *without, *run]),
            (0, ["-n", "1", *without, *run, ":", "-n", "2", *run]),
        ):
            status, errors = call(mpiexec, *ranks)
            assert status == 3 and len(errors) == 1 and errors[0].startswith(f"rank {rank}: {cause}"), (
                status,
                errors,
            )
        status, errors = call(mpiexec, "-n", "2", *without, *run)
        assert status == 3 and len(errors) == 1 and errors[0].startswith(cause), (status, errors)

        # Ranks that are to do different things.
        for other in (
            program.command("elsewhere"),
            program.command("out", ["title=a"]),
            [weavefront, "run", folder / "other.yaml", *run[3:]],
            [weavefront, "check", *run[2:3]],
            [weavefront, "rnu"],
        ):
            status, errors = call(mpiexec, "-n", "1", *run, ":", "-n", "1", *other)
            told = " ".join(map(str, other[1:]))
            assert status == 2 and len(errors) == 1, errors
            assert (
                f"the ranks were started differently: rank 1 as weavefront {told} of version" in errors[0]
            ), errors
            assert f"rank 0 as weavefront {' '.join(run[1:])} of version" in errors[0], errors
        assert not (folder / "out").exists() and not (folder / "elsewhere").exists()


main()
