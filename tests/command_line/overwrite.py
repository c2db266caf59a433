"""What a folder holds of an earlier run stays until a new one is certain to start: overwrite.py WEAVEFRONT
MPIEXEC"""

import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from small_run import FILES, LONG, Program, bytes_of, processes_of, summary

# Refused when everything is set up, and before: time step of nothing, a file larger than the system takes, a
# fault in the scene.
GUARD = ["contact.plies={stiffness: 1e308 N/m^3}"]
TOO_LARGE = [*LONG, "output.interval=0.05 us"]


def limit_file_size():
    resource.setrlimit(resource.RLIMIT_FSIZE, (32 << 20, 32 << 20))


def refused_runs_leave_the_earlier_one(program, folder):
    program.run("out", status=0)
    before = bytes_of(folder / "out")
    assert set(before) == FILES
    assert summary(folder / "out")["history_sha256"]
    for options in ([], ["--overwrite"]):
        for ranks in (1, 2):
            wanted = 1 if options else 2
            (error,) = program.run("out", GUARD, ranks, options, status=wanted)
            assert ("the time step vanished" if options else "--overwrite replaces it") in error, error
            if ranks == 1:  # mpirun itself would suffer
                (error,) = program.run(
                    "out", TOO_LARGE, ranks, options, status=3 if options else 2, preexec_fn=limit_file_size
                )
                assert (
                    "out/results.vtkhdf may grow to" if options else "--overwrite replaces it"
                ) in error, error
            program.run("out", ["time.end=-1 us"], ranks, options, status=2)
            assert bytes_of(folder / "out") == before, (options, ranks)
    program.run("out", ["title=Another"], options=["--overwrite"])
    assert summary(folder / "out")["title"] == "Another"
    assert set(bytes_of(folder / "out")) == FILES
    assert (
        "replaces      summary.json, history.csv, results.vtkhdf, run.log"
        in (folder / "out/run.log").read_text()
    )


def killed_runs_are_refused_by_name(program, folder):
    process = program.start("killed")
    process.kill()
    process.communicate()
    left = set(bytes_of(folder / "killed"))
    assert left == {"history.csv", "results.vtkhdf", "run.log", "run.lock"}, left
    (error,) = program.run("killed", status=2)
    assert (
        "holds a run already (history.csv, results.vtkhdf, run.log): --overwrite replaces it" in error
    ), error
    (folder / "killed/results.vtkhdf").rename(folder / "killed/results.vtkhdf.new")
    (error,) = program.run("killed", status=2)
    assert "results.vtkhdf.new" in error, error
    program.run("killed", options=["--overwrite"])
    assert set(bytes_of(folder / "killed")) == FILES


def kills_while_setting_up_leave_one_run(program, folder):
    program.run("up", status=0)
    before = bytes_of(folder / "up")
    outcomes = set()
    for ranks in (1, 2):
        for delay in (0, 0.002, 0.005, 0.02, 0.1):
            for name, text in before.items():
                (folder / "up" / name).write_bytes(text)
            command = program.command(
                "up",
                ["target.mesh={center: 0.2 mm, edge: 0.2 mm}", "output.interval=0"],
                ranks,
                ["--overwrite"],
            )
            process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            while not list((folder / "up").glob("*.new")):
                assert process.poll() is None
            time.sleep(delay)
            for pid in processes_of(process):
                os.kill(pid, signal.SIGKILL)
            process.wait()
            now = bytes_of(folder / "up")
            old = {name for name in before if now.get(name) == before[name]}
            assert old in (set(), FILES), f"{old} of the earlier run beside {set(now) - old}"
            outcomes.add(bool(old))
            while program_is_alive(folder / "up"):
                time.sleep(0.01)
            (error,) = program.run("up", status=2)
            assert "holds a run already" in error, error
            program.run("up", options=["--overwrite"])
            assert set(bytes_of(folder / "up")) == FILES
    assert True in outcomes, "no kill came before the new run started"


def program_is_alive(folder):
    """Whether the process that holds the lock of a folder has not ended yet."""
    words = (folder / "run.lock").read_text().split()
    stat = Path(f"/proc/{words[words.index('process') + 1]}/stat")
    return stat.exists() and stat.read_text().rpartition(")")[2].split()[0] != "Z"


def moved_folders_are_noticed(program, folder):
    for ranks in (1, 2):
        process = program.start("moved", ranks=ranks)
        (folder / "moved").rename(folder / f"elsewhere {ranks}")
        text = process.communicate(timeout=60)[1]
        # Whichever is written to first.
        lost = re.search(r"moved/(history\.csv|results\.vtkhdf) is no longer there", text)
        assert process.returncode == 3 and lost, (process.returncode, text)
        assert "Ended at t = " in (folder / f"elsewhere {ranks}/run.log").read_text()


def links_are_refused(program, folder):
    (folder / "linked").mkdir()
    for name in ("results.vtkhdf", "history.csv"):
        (folder / "linked" / name).symlink_to(folder / "scratch")
        for options in ([], ["--overwrite"]):
            (error,) = program.run("linked", options=options, status=3)
            assert f"linked/{name} cannot be written: it is a link" in error, error
        (folder / "linked" / name).unlink()
    assert not (folder / "scratch").exists()
    (folder / "disk").mkdir()
    (folder / "link").symlink_to(folder / "disk")
    program.run("link")
    assert set(bytes_of(folder / "disk")) == FILES


def main():
    weavefront, mpiexec = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        program = Program(weavefront, mpiexec, folder)
        for check in (
            refused_runs_leave_the_earlier_one,
            killed_runs_are_refused_by_name,
            kills_while_setting_up_leave_one_run,
            moved_folders_are_noticed,
            links_are_refused,
        ):
            print(check.__name__, flush=True)
            check(program, folder)


main()
