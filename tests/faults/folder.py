"""An output folder that is missing, read-only, or taken away during a run: folder.py WEAVEFRONT MPIEXEC"""

import shutil
import sys
import tempfile
from pathlib import Path

from fault import FRAMES, LONG, Disk, Program, end_by, enter_own_mounts, require

GONE = "is no longer there: the file or its folder was moved, removed or replaced while the run wrote to it"


def main():
    enter_own_mounts()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        folder = Path(scratch)
        program = Program(*sys.argv[1:], folder)
        program.run("missing/with/parents", ("time.end=1 us",), 2)

        (folder / "file").write_text("")
        require(
            end_by(program, "file/out"),
            3,
            f"output directory {folder}/file/out cannot be created: Not a directory",
        )
        disk = Disk(folder / "read_only", "1m")
        disk.make_read_only()
        for ranks in (1, 2):
            require(
                end_by(program, "read_only", ranks=ranks),
                3,
                f"output directory {folder}/read_only cannot be written to: Read-only file system",
            )
            require(
                end_by(program, "read_only/out", ranks=ranks),
                3,
                f"output directory {folder}/read_only/out cannot be created: Read-only",
            )
        disk.unmount()

        # Noticed at once where much is written, and else within 1000 steps.
        often = [*LONG, *FRAMES]
        seldom = [*LONG, "time.end=200 ms", "output.interval=200 ms", "output.history=200 ms"]  # some minutes
        for ranks, overrides in ((1, seldom), (2, seldom), (3, often)):
            output = f"removed{ranks}"
            require(
                end_by(program, output, overrides, ranks, fault=lambda _: shutil.rmtree(folder / output)),
                3,
                GONE,
            )
            assert not (folder / output).exists()
        require(
            end_by(
                program, "moved", often, 2, fault=lambda _: (folder / "moved").rename(folder / "elsewhere")
            ),
            3,
            GONE,
        )
        assert "Ended at t = " in (folder / "elsewhere/run.log").read_text()


main()
