"""A run is killed at random moments, and restarted on random numbers of ranks each time: its files are those
of an uninterrupted run.

kill.py WEAVEFRONT MPIEXEC [KILLS [SEED]]: with 50, all of it in some minutes. One rank, all ranks or mpirun
itself is sent SIGKILL: while the run sets up, computes, writes rows, frames or a checkpoint."""

import os
import random
import signal
import sys
import tempfile
import time
from pathlib import Path

from perforation import KILLED, PERFORATION, Program, differences, errors_of, processes_of, start, whole_run


def is_alive(folder):
    """Whether the process that holds the lock of the folder is still there."""
    lock = folder / "run.lock"
    words = lock.read_text().split() if lock.exists() else []
    if "process" not in words:
        return False
    stat = Path(f"/proc/{words[words.index('process') + 1]}/stat")
    return stat.exists() and stat.read_text().rpartition(")")[2].split()[0] != "Z"


def kill(process, whom, random_number):
    pids = processes_of(process)
    victims = {"rank": random_number.sample(pids, min(1, len(pids))), "all": pids, "mpirun": [process.pid]}[
        whom
    ]
    for pid in victims:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass


def wait_until_dead(folder):
    deadline = time.monotonic() + 20
    while is_alive(folder):
        assert time.monotonic() < deadline, "a killed run goes on"
        time.sleep(0.01)


def killed_until_it_ends(program, output, whole, kills, seconds, random_number):
    """Returns how many kills there were and how often a checkpoint was under way."""
    folder = program.folder / output
    done = hits = 0
    while True:
        ranks = random_number.randrange(1, 5)
        can_go_on = any((folder / name).exists() for name in ("checkpoint.h5", "checkpoint.previous.h5"))
        options = ["--restart", "auto"] if can_go_on else ["--overwrite"]
        options += ["--checkpoint-every", f"{random_number.choice((20, 60, 200))} steps"]
        process = start(program, output, PERFORATION, ranks, options)
        if done < kills:
            moment = time.monotonic() + random_number.uniform(0, seconds)
            in_checkpoint = random_number.random() < 0.4
            while process.poll() is None and time.monotonic() < moment:
                time.sleep(0.001)
            while in_checkpoint and process.poll() is None and not (folder / "checkpoint.h5.new").exists():
                time.sleep(0.0005)
            if process.poll() is None:
                hits += (folder / "checkpoint.h5.new").exists()
                kill(process, random_number.choice(("rank", "all", "mpirun")), random_number)
                done += 1
        text = process.communicate(timeout=120)[1]
        if process.returncode == 3 and "is in use by another run" in text:
            wait_until_dead(folder)  # a rank that the killed mpirun had only just started
            continue
        if process.returncode == 0:
            if done >= kills:
                return done, hits
            assert differences(whole, folder) == []
            for path in folder.iterdir():
                path.unlink()
        else:
            assert process.returncode in (*KILLED, 1) and not errors_of(text), (
                options,
                process.returncode,
                text,
            )
        wait_until_dead(folder)


def main():
    weavefront, mpiexec, *rest = sys.argv[1:]
    kills, seed = (int(rest[0]) if rest else 8), (int(rest[1]) if len(rest) > 1 else 1)
    random_number = random.Random(seed)
    with tempfile.TemporaryDirectory() as scratch:
        program = Program(weavefront, mpiexec, Path(scratch))
        began = time.monotonic()
        whole = whole_run(program)
        seconds = time.monotonic() - began
        done, hits = killed_until_it_ends(program, "out", whole, kills, seconds, random_number)
        assert differences(whole, program.folder / "out") == []
    print(f"{done} kills, {hits} of them while a checkpoint was written, seed {seed}")


main()
