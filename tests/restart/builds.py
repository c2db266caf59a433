"""Every build writes the same bytes, and goes on with the run of another: builds.py MPIEXEC WEAVEFRONT..."""

import hashlib
import sys
import tempfile
from pathlib import Path

from perforation import PERFORATION, Program, summary, whole_run

# Changed only together with the physics, or the columns and arrays, and by a commit that says why.
PINNED = {
    "history.csv": "a0ab296a99c907fd1e8c877b878b7b516fc437b86f071d2d43c76191bebe16ad",
    "results.vtkhdf": "68d13ad0c8244f6e45f961cc615860328eacec778aa48c9d99e92b8bb2c321d0",
}


def require_pinned(run):
    for name, key in (("history.csv", "history_sha256"), ("results.vtkhdf", "results_sha256")):
        found = hashlib.sha256((run / name).read_bytes()).hexdigest()
        assert summary(run)[key] == found, (run, name)
        assert found == PINNED[name], (run, name, found)


def main():
    mpiexec, *builds = sys.argv[1:]
    builds = [build for build in builds if Path(build).exists()]
    print("\n".join(builds))
    with tempfile.TemporaryDirectory() as scratch:
        programs = [Program(build, mpiexec, Path(scratch)) for build in builds]
        for number, program in enumerate(programs):
            require_pinned(whole_run(program, f"whole{number}"))
            programs[number - 1].run(
                f"two{number}", [*PERFORATION, "time.end=20 us"], 2, ["--checkpoint-every", "90 steps"]
            )
            program.run(f"two{number}", PERFORATION, 1, ["--restart", "auto"])
            require_pinned(Path(scratch) / f"two{number}")


main()
