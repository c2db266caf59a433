"""Runs in jobs of a real Slurm go on until they are done: jobs.py WEAVEFRONT MPIEXEC MPI, MPI as in srun
--mpi. Needs root."""

import os
import re
import sys
import tempfile
import time
from pathlib import Path

from cluster import Cluster

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/restart"))

from perforation import PERFORATION, Program, differences, summary  # noqa: E402
from small_run import is_open_mpi, sets  # noqa: E402

IMPACT = [override for override in PERFORATION if not override.startswith("time.end")]
ENDLESS = "10 ms"

# Starts the program 15 s before the end of the job, as a job does that is busy with other things first.
LATE = """#!/bin/bash
if [ ! -e runs/large_panel/checkpoint.h5 ]; then sleep $((SLURM_JOB_END_TIME - $(date +%s) - 15)); fi
exec weavefront "$@"
"""


class Job:
    """A job whose run has no end until `finish` gives it one, however fast the machine is."""

    def __init__(self, cluster, program, name, script, output, *options):
        self.cluster, self.program = cluster, program
        self.folder = program.folder / name
        self.output = self.folder / output
        self.scene = self.folder / "scene.yaml"
        self.folder.mkdir()
        self.set_end(ENDLESS)
        self.begin = time.monotonic()
        self.identifier = cluster.call(
            "sbatch",
            "--parsable",
            f"--chdir={self.folder}",
            "--output=out",
            *options,
            str(script),
            "scene.yaml",
            *sets(IMPACT),
        )

    def set_end(self, end):
        text = (self.program.folder / "scene.yaml").read_text()
        self.scene.write_text(re.sub(r"time: \{.*\}", f"time: {{end: {end}}}", text))
        self.end = end

    def show(self, key):
        return re.search(rf"\b{key}=(\S*)", self.cluster.call("scontrol", "show", "job", self.identifier))[1]

    def text(self):
        out = self.folder / "out"
        return out.read_text() if out.exists() else ""

    def wait_for(self, condition, seconds=100):
        end = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < end, (
                self.folder.name,
                self.cluster.call("scontrol", "show", "job", self.identifier),
                self.text(),
            )
            time.sleep(0.1)

    def wait_until_it_runs(self):
        self.wait_for((self.output / "results.vtkhdf").exists)

    def leaves(self, reason):
        """Waits for a checkpoint that was written for `reason`, then lets the requeued job compute some
        output intervals more."""
        self.wait_for((self.output / "summary.json").exists)
        found = summary(self.output)
        assert (found["status"], found["reason"]) == ("interrupted", reason), (
            self.folder.name,
            found,
            self.text(),
        )
        assert (self.output / "checkpoint.h5").exists()
        self.set_end(f"{2 * round(found['time'] * 1e6 / 2) + 4} us")
        print(f"{self.folder.name}: {reason} after {time.monotonic() - self.begin:.0f} s", flush=True)

    def finishes(self):
        """The files of the requeued job are those of an uninterrupted run."""
        self.wait_for(lambda: self.show("JobState") in ("COMPLETED", "FAILED", "CANCELLED", "TIMEOUT"))
        assert self.show("JobState") == "COMPLETED" and int(self.show("Restarts")) >= 1, self.text()
        self.program.run(self.folder.name + "/whole", [*IMPACT, f"time.end={self.end}"])
        assert differences(self.folder / "whole", self.output) == [], self.folder.name
        print(f"{self.folder.name}: same files after {time.monotonic() - self.begin:.0f} s", flush=True)


def mpirun_script(folder):
    """The job script of src/io/README.md, with the arguments of the job."""
    (script,) = re.findall(
        r"```bash\n(#!/bin/bash\n.*?)```", (ROOT / "src/io/README.md").read_text(), re.DOTALL
    )
    (folder / "mpirun.sh").write_text(script.replace("run scene.yaml", 'run "$@"'))
    return folder / "mpirun.sh"


def commands(folder, weavefront, mpiexec):
    """A folder with the commands that the job scripts call."""
    folder.mkdir()
    (folder / "weavefront").symlink_to(weavefront)
    (folder / "mpirun").symlink_to(mpiexec)
    (folder / "late").write_text(LATE)
    (folder / "late").chmod(0o755)
    return folder


def main():
    weavefront, mpiexec, mpi = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch, Cluster(Path(scratch) / "cluster", mpi) as cluster:
        folder = Path(scratch)
        program = Program(weavefront, mpiexec, folder)
        cluster.environment["PATH"] = f"{commands(folder / 'bin', weavefront, mpiexec)}:{os.environ['PATH']}"

        def job(name, ranks=2, signal="USR1@0", command="weavefront"):  # a signal at 0 s is none
            return Job(
                cluster,
                program,
                name,
                ROOT / "examples/large_panel/job.sh",
                "runs/large_panel",
                "--nodes=1",
                "--time=1",
                f"--ntasks-per-node={ranks}",
                f"--signal={signal}",
                f"--export=ALL,WEAVEFRONT={command},SCRATCH=runs",
            )

        # The time limit comes near: the run sees it, or Slurm sends the signal to the ranks.
        late = job("late", command="late")
        signalled = job("signalled", 1, signal="USR1@10")

        requeued = job("requeued")
        requeued.wait_until_it_runs()
        cluster.call("scontrol", "requeue", requeued.identifier)
        requeued.leaves("SIGTERM received")

        by_hand = job("by_hand")
        by_hand.wait_until_it_runs()
        cluster.call("scancel", "--signal=USR1", by_hand.identifier)
        by_hand.leaves("SIGUSR1 received")

        going_on = [late, signalled, requeued, by_hand]
        if is_open_mpi(mpiexec):  # that of MPICH does not tell a script the status
            by_mpirun = Job(
                cluster, program, "mpirun", mpirun_script(folder), "run", "--ntasks=2", "--time=5"
            )
            by_mpirun.wait_until_it_runs()
            cluster.call(
                "scancel", "--batch", "--signal=USR1", by_mpirun.identifier
            )  # as Slurm does for --signal=B:USR1
            by_mpirun.leaves("SIGUSR1 received")
            going_on.append(by_mpirun)

        # For good, with a checkpoint.
        cancelled = job("cancelled")
        cancelled.wait_until_it_runs()
        cluster.call("scancel", cancelled.identifier)
        cancelled.leaves("SIGTERM received")

        stopped = job("stopped")
        stopped.wait_until_it_runs()
        (stopped.output / "stop").touch()
        stopped.leaves("the file runs/large_panel/stop was found")

        signalled.leaves("SIGUSR1 received")
        late.leaves("the Slurm job is about to end")
        for each in going_on:
            each.finishes()
        assert (cancelled.show("JobState"), cancelled.show("Restarts")) == (
            "CANCELLED",
            "0",
        ), cancelled.text()
        assert (stopped.show("JobState"), stopped.show("Restarts"), stopped.show("ExitCode")) == (
            "FAILED",
            "0",
            "4:0",
        ), stopped.text()


main()
