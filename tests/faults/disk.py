"""A disk that is full at the start, at a row, at a frame or at a checkpoint ends a run in good order:
disk.py WEAVEFRONT MPIEXEC"""

import os
import signal
import sys
import tempfile
from pathlib import Path

from fault import (
    FRAMES,
    LONG,
    Disk,
    Program,
    end_by,
    enter_own_mounts,
    require,
    require_readable,
    require_restart,
)

FULL = "cannot be written: No space left on device"


def check_start(program, disk, ranks):
    """Nothing is left, and nothing of an earlier run is touched."""
    output = f"disk/start{ranks}"
    disk.fill(leave=1 << 16)
    require(
        end_by(program, output, (), ranks),
        3,
        " GB are free there: write fewer frames (output.interval) or fields (output.fields), or to "
        "another disk (--output)",
    )
    assert not (program.folder / output).exists()
    disk.free()
    program.run(output, (), ranks)
    before = {path.name: path.read_bytes() for path in (program.folder / output).iterdir()}
    disk.fill(leave=1 << 16)
    require(end_by(program, output, (), ranks, ["--overwrite"]), 3, "GB are free there")
    assert {path.name: path.read_bytes() for path in (program.folder / output).iterdir()} == before
    disk.free()


def check_stage(program, disk, stage, ranks):
    output = f"disk/{stage}{ranks}"
    overrides, options, file, ready = {
        "rows": ([*LONG, "output.history=0.1 us"], (), "history.csv", "results.vtkhdf"),
        "frames": ([*LONG, *FRAMES], (), "results.vtkhdf", "results.vtkhdf"),
        "checkpoints": (LONG, ["--checkpoint-every", "30 steps"], "checkpoint.h5", "checkpoint.previous.h5"),
        "last_checkpoint": (LONG, (), "checkpoint.h5", "results.vtkhdf"),
    }[stage]

    def fill(pids):
        disk.fill()
        if stage == "last_checkpoint":
            os.kill(pids[-1], signal.SIGTERM)

    ended = end_by(program, output, overrides, ranks, options, fill, ready)
    require(ended, 3, FULL)
    assert file in ended[1][0], ended
    require_readable(program.folder / output, FULL)
    disk.free()
    if stage == "checkpoints":
        require_restart(program, output, 3 - ranks if ranks < 3 else 1)


def main():
    enter_own_mounts()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        program = Program(*sys.argv[1:], Path(scratch))
        disk = Disk(program.folder / "disk")
        check_start(program, disk, 1)
        check_start(program, disk, 2)
        for stage in ("rows", "frames", "checkpoints", "last_checkpoint"):
            for ranks in (1, 3 if stage == "frames" else 2):
                check_stage(program, disk, stage, ranks)
        disk.unmount()


main()
