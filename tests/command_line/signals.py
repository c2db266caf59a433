"""A signal ends a run in good order, and what was written before stays as it would have been: signals.py
WEAVEFRONT MPIEXEC"""

import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import h5py

from small_run import (
    FILES,
    LONG,
    Program,
    bytes_of,
    errors_of,
    processes_of,
    statuses_when_signalled,
    summary,
)


def check_interrupted(folder, name, whole):
    """The files are those of an uninterrupted run up to the last row, which is also the last frame."""
    found = summary(folder)
    assert (found["status"], found["reason"]) == ("interrupted", f"{name} received"), found
    assert set(bytes_of(folder)) - {"checkpoint.previous.h5"} == FILES | {"checkpoint.h5"}
    rows = (folder / "history.csv").read_bytes().splitlines()
    assert 1 < len(rows) < len(whole) and rows[:-1] == whole[: len(rows) - 1]
    with h5py.File(folder / "results.vtkhdf") as file:
        steps = file["VTKHDF/Steps"]
        assert len(steps["Values"]) == steps.attrs["NSteps"]
        assert steps["Values"][-1] == float(rows[-1].split(b",")[0]) == found["time"]
    assert f"Interrupted at t = {found['time'] * 1e6:.6g} us" in (folder / "run.log").read_text()


def main():
    weavefront, mpiexec = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        program = Program(weavefront, mpiexec, folder)
        program.run("whole", LONG)
        whole = (folder / "whole/history.csv").read_bytes().splitlines()

        # One rank alone is sent it; the others agree.
        for ranks, sent in (
            (1, signal.SIGTERM),
            (1, signal.SIGINT),
            (2, signal.SIGUSR1),
            (3, signal.SIGUSR2),
            (4, signal.SIGTERM),
        ):
            output = folder / f"{sent.name} on {ranks}"
            process = program.start(output.name, ranks=ranks)
            time.sleep(0.2)
            pids = processes_of(process)
            assert len(pids) == ranks, pids
            os.kill(pids[-1], sent)
            text = process.communicate(timeout=60)[1]
            assert process.returncode == 4, (ranks, sent, process.returncode, text)
            (error,) = errors_of(text)
            assert error.startswith(
                f"{sent.name} received: a checkpoint was written; to go on: weavefront run "
            ), error
            check_interrupted(output, sent.name, whole)

        # mpirun passes this one on to all ranks and waits for them.
        process = program.start("out", ranks=2)
        time.sleep(0.2)
        process.send_signal(signal.SIGUSR1)
        process.communicate(timeout=60)
        assert process.returncode in statuses_when_signalled(mpiexec), process.returncode
        check_interrupted(folder / "out", "SIGUSR1", whole)

        # Before the first step nothing of an earlier run is touched.
        before = bytes_of(folder / "out")
        long_setup = program.command(
            "out", ["target.mesh={center: 0.1 mm, edge: 0.1 mm}"], ranks=2, options=["--overwrite"]
        )
        process = subprocess.Popen(long_setup, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while not (folder / "out/run.lock").exists():
            time.sleep(0.01)
        os.kill(processes_of(process)[0], signal.SIGTERM)
        text = process.communicate(timeout=60)[1]
        assert process.returncode == 4 and errors_of(text) == [
            "SIGTERM received before the first step: nothing was written"
        ], text
        assert bytes_of(folder / "out") == before

        # A second interrupt is not waited for.
        process = program.start("twice")
        process.send_signal(signal.SIGSTOP)
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGCONT)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        assert process.returncode in (-signal.SIGINT, 4), process.returncode

        # A reader of the output that goes away, as head does.
        reading, writing = os.pipe()
        os.close(reading)
        done = subprocess.run(
            program.command("unread"), stdout=writing, stderr=subprocess.PIPE, text=True, timeout=60
        )
        assert done.returncode == 0 and set(bytes_of(folder / "unread")) == FILES, done
        assert "Finished at" in (folder / "unread/run.log").read_text()


main()
