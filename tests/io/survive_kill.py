"""Whatever the moment at which its writer is killed, a results file opens and all the frames it counts are
right: survive_kill.py WRITER MPIEXEC [KILLS]"""

import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import model

FRAMES = 2000  # more than a writer lives to write


def kill_writer(command, ranks, path, delay):
    """Starts the writer and kills its processes `delay` seconds after the file has its name (before, when
    negative)."""
    writer = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    pids = [int(writer.stdout.readline()) for _ in range(ranks)]
    if delay < 0:
        time.sleep(-delay)
    else:
        while not path.exists():
            assert writer.poll() is None, "the writer ended by itself"
            time.sleep(0.001)
        time.sleep(delay)
    assert writer.poll() is None, "the writer ended by itself"
    for pid in pids:
        os.kill(pid, signal.SIGKILL)
    writer.wait()
    writer.stdout.close()


def main():
    writer, mpiexec = sys.argv[1:3]
    kills = int(sys.argv[3]) if len(sys.argv) > 3 else 18
    random.seed(1)
    counted = []
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "results.vtkhdf"
        for kill in range(kills):
            ranks = 2 if kill % 3 == 2 else 1
            # Every other writer has too little room at first, and makes more again and again.
            room = FRAMES if kill % 2 == 0 else 1
            command = ([mpiexec, "-n", str(ranks)] if ranks > 1 else []) + [
                writer,
                str(path),
                str(FRAMES),
                str(room),
                "1",
            ]
            # Every fourth kill falls into the creation of the file, over one that a killed run left.
            early = kill % 4 == 3
            if not early:
                path.unlink(missing_ok=True)
            path.with_suffix(".vtkhdf.new").unlink(missing_ok=True)
            kill_writer(
                command,
                ranks,
                path,
                -random.uniform(0, 0.2) if early else random.uniform(0, 0.03 if room > 1 else 0.2),
            )
            if path.exists():
                # The two numbers that publish a frame are written one right after the other: a kill may fall
                # between them.
                counted.append(model.check_frames(path, surplus_times=1))
    print("frames read:", counted)
    assert len(counted) >= 0.8 * kills, "too few kills left a file"
    assert max(counted) > 5 and len(set(counted)) > kills / 4, "the kills did not fall among the frames"


main()
