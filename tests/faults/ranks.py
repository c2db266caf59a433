"""A rank that is killed or fails alone ends all ranks, and too little shared memory ends none:
ranks.py WEAVEFRONT MPIEXEC"""

import os
import resource
import signal
import sys
import tempfile
from pathlib import Path

from fault import (
    KILLED,
    LONG,
    Disk,
    Program,
    end_by,
    enter_own_mounts,
    is_open_mpi,
    require,
    require_readable,
    require_restart,
)

CHECKPOINTS = ["--checkpoint-every", "30 steps"]


def check_killed(program, ranks):
    """mpirun says so; nothing is left behind that a restart would not get over."""
    output = f"killed{ranks}"
    status, errors = end_by(
        program,
        output,
        LONG,
        ranks,
        CHECKPOINTS,
        lambda pids: os.kill(pids[-1], signal.SIGKILL),
        "checkpoint.previous.h5",
    )
    assert status in KILLED and not errors, (status, errors)
    require_restart(program, output, ranks)
    require_readable(program.folder / output)


def check_failing_alone(program, name, ranks, limit, message):
    """The last rank meets a limit of its own at its next checkpoint, and the others do not wait for it."""
    output = f"{name}{ranks}"
    ended = end_by(
        program,
        output,
        LONG,
        ranks,
        CHECKPOINTS,
        lambda pids: resource.prlimit(pids[-1], *limit),
        "checkpoint.previous.h5",
    )
    require(ended, 3, message)
    require_readable(program.folder / output, message)
    require_restart(program, output, ranks)


def check_shared_memory(program, size, is_lacking):
    """Ranks that cannot share memory send messages: same rows, and a warning."""
    disk = Disk("/dev/shm", size)
    output, short = f"shared_{size}", ("target.mesh={center: 0.5 mm, edge: 1 mm}", "time.end=2 us")
    program.run(output, short, 2)  # some hundred times slower where processes share cores
    log = (program.folder / output / "run.log").read_text()
    assert ("/dev/shm has no room for the memory that they would share" in log) == is_lacking, log
    disk.unmount()
    if not (program.folder / "whole").exists():
        program.run("whole", short)
    assert (program.folder / output / "history.csv").read_bytes() == (
        program.folder / "whole/history.csv"
    ).read_bytes()


def check_shared_memory_filled(program):
    """Memory that is shared already is not taken back."""
    disk = Disk("/dev/shm", "40m")
    short = [*LONG, "time.end=100 us", "output.interval=20 us", "output.history=20 us"]
    assert end_by(program, "filled", short, 2, fault=lambda _: disk.fill())[0] == 0
    disk.unmount()


def main():
    enter_own_mounts()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        program = Program(*sys.argv[1:], Path(scratch))
        for ranks in (1, 2, 3):
            check_killed(program, ranks)
        check_failing_alone(program, "opening", 2, (resource.RLIMIT_NOFILE, (3, 3)), "Too many open files")
        check_failing_alone(
            program, "writing", 3, (resource.RLIMIT_FSIZE, (100, 100)), "cannot be written: File too large"
        )
        if is_open_mpi(program.mpiexec):  # MPICH's own start needs more
            check_shared_memory(program, "16k", True)
        check_shared_memory(program, "64m", False)
        check_shared_memory_filled(program)


main()
