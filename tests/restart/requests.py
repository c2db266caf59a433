"""What makes a run write a checkpoint, and leave: requests.py WEAVEFRONT MPIEXEC"""

import os
import signal
import sys
import tempfile
import time
from pathlib import Path

from perforation import (
    PERFORATION,
    Program,
    differences,
    errors_of,
    is_open_mpi,
    processes_of,
    start,
    statuses_when_signalled,
    summary,
    whole_run,
)


# Some seconds, so that it does not end before it is asked to leave.
LONG = [*PERFORATION, "target.mesh={center: 0.5 mm, edge: 0.5 mm}", "time.end=45 us"]


def wait_for(path, process):
    while not path.exists():
        assert process.poll() is None, process.communicate()
        time.sleep(0.005)


def leave(program, output, ranks, request, environment=None, statuses=None):
    """Starts a run, asks it to leave by `request` and returns the reason that it gives."""
    if environment:
        os.environ.update(environment)
    process = start(program, output, LONG, ranks, ())
    for name in environment or ():
        del os.environ[name]
    wait_for(program.folder / output / "results.vtkhdf", process)
    request(process)
    text = process.communicate(timeout=60)[1]
    assert process.returncode in (statuses or statuses_when_signalled(program.mpiexec)), (
        process.returncode,
        text,
    )
    (error,) = errors_of(text)
    assert (program.folder / output / "checkpoint.h5").exists()
    assert summary(program.folder / output)["status"] == "interrupted"
    return error.split(": a checkpoint was written; to go on: ")[0]


def terminate_slowly(process):
    """Sends SIGTERM to mpirun and keeps a rank from leaving for 4.5 s, longer than Open MPI waits by
    itself."""
    rank = processes_of(process)[-1]
    process.send_signal(signal.SIGTERM)
    time.sleep(0.3)  # mpirun wakes all ranks first
    os.kill(rank, signal.SIGSTOP)
    time.sleep(4.2)
    os.kill(rank, signal.SIGCONT)


def main():
    weavefront, mpiexec = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        program = Program(weavefront, mpiexec, folder)
        whole = whole_run(program, overrides=LONG)
        requests = {
            "a signal to the last rank": (
                3,
                lambda process: os.kill(processes_of(process)[-1], signal.SIGTERM),
                "SIGTERM received",
            ),
            "a signal that mpirun passes on": (
                2,
                lambda process: process.send_signal(signal.SIGUSR1),
                "SIGUSR1 received",
            ),
            "interrupt": (1, lambda process: process.send_signal(signal.SIGINT), "SIGINT received"),
            "file": (
                2,
                lambda process: (folder / "file/stop").touch(),
                f"the file {folder / 'file/stop'} was found",
            ),
        }
        for output, (ranks, request, reason) in requests.items():
            assert leave(program, output, ranks, request) == reason, output
            assert not (folder / output / "stop").exists()
            program.run(output, LONG, 4 - ranks, ["--restart", "auto"])
            assert differences(whole, folder / output) == [], output

        # Open MPI's mpirun passes SIGTERM on 4 s later, waits 4 s more and returns 1.
        if is_open_mpi(mpiexec):
            patient = {"OMPI_MCA_odls_base_sigkill_timeout": "4"}
            assert (
                leave(program, "patient", 2, terminate_slowly, environment=patient, statuses={1})
                == "SIGTERM received"
            )

        # The end of a Slurm job comes near.
        in_slurm = {"SLURM_JOB_END_TIME": str(int(time.time()) + 3)}
        assert (
            leave(program, "slurm", 1, lambda _: None, environment=in_slurm)
            == "the Slurm job is about to end"
        )

        # By the clock, without leaving.
        program.run("clock", LONG, 2, ["--checkpoint-every", "0.2 s"])
        assert differences(whole, folder / "clock") == []
        assert (folder / "clock/run.log").read_text().count("  checkpoint    checkpoint.h5 at t = ") >= 2
        assert (folder / "clock/checkpoint.previous.h5").exists()

        for text, problem in (
            ("5000 stps", "--checkpoint-every: "),
            ("0 steps", "--checkpoint-every: found '0 steps', allowed at least 1 step"),
            ("10", "--checkpoint-every: "),
            ("-1 min", "--checkpoint-every: found '-1 min', allowed a time above 0"),
        ):
            (error,) = program.run("none", PERFORATION, 1, ["--checkpoint-every", text], status=2)
            assert problem in error and not (folder / "none").exists(), error
        program.run("none", PERFORATION, 1, ["--restart", "auto", "--overwrite"], status=2)


main()
