"""Runs go on and on: soak.py WEAVEFRONT MPIEXEC [MINUTES [SEED]], 30 minutes by default.

Each run has output settings by chance. It is left and restarted by chance, on random numbers of ranks, with
and without rebalancing, and is compared with an uninterrupted run. Before, a small run of 500,000 steps must
not take more and more memory."""

import os
import random
import signal
import sys
import tempfile
import time
from pathlib import Path

from perforation import PERFORATION, Program, differences, processes_of, start, summary, whole_run

SIGNALS = (signal.SIGTERM, signal.SIGUSR1, signal.SIGUSR2)

# Some 500,000 steps of few elements that touch and let go: a ball bounces on a net.
BOUNCING = (
    "target.mesh={center: 5 mm, edge: 5 mm}",
    "time.end=24 ms",
    "output.interval=2 ms",
    "output.history=20 us",
    "projectile.velocity=[0, 0, 3 m/s]",
)


def resident(pid):
    """Memory of a process, bytes."""
    pages = int(Path(f"/proc/{pid}/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


def memory_of_a_long_run(program):
    """Memory while it computes, bytes, from its second quarter on."""
    process = start(program, "bouncing", BOUNCING, 1, [])
    memory = []
    while process.poll() is None:
        try:
            memory.append(resident(process.pid))
        except (FileNotFoundError, IndexError):
            break
        time.sleep(0.05)
    process.communicate(timeout=60)
    found = summary(program.folder / "bouncing")
    assert found["status"] == "finished" and found["steps"] > 200_000, found
    return memory[len(memory) // 4 : -1]


def run_in_pieces(program, output, overrides, random_number):
    """Returns how many pieces there were."""
    pieces = 0
    options = []
    while True:
        ranks = random_number.randrange(1, 5)
        more = ["--rebalance", random_number.choice(("0", "0.2"))] if random_number.random() < 0.5 else []
        more += ["--checkpoint-every", random_number.choice(("0.3 s", "40 steps", "300 steps"))]
        process = start(program, output, overrides, ranks, options + more)
        time.sleep(random_number.uniform(0.3, 1.5))
        pids = processes_of(process)
        if process.poll() is None and pids:
            os.kill(random_number.choice(pids), random_number.choice(SIGNALS))
        text = process.communicate(timeout=300)[1]
        pieces += 1
        if process.returncode == 0:
            return pieces
        # A signal that comes before the program has begun ends the process.
        assert process.returncode in (4, *(128 + number for number in SIGNALS)), (process.returncode, text)
        options = ["--restart", "auto"] if (program.folder / output / "checkpoint.h5").exists() else []


def main():
    weavefront, mpiexec, *rest = sys.argv[1:]
    minutes, seed = (float(rest[0]) if rest else 30), (int(rest[1]) if len(rest) > 1 else int(time.time()))
    random_number = random.Random(seed)
    end = time.monotonic() + 60 * minutes
    runs = pieces = 0
    with tempfile.TemporaryDirectory() as scratch:
        program = Program(weavefront, mpiexec, Path(scratch))
        memory = memory_of_a_long_run(program)
        assert max(memory) < 1.05 * memory[0], memory
        print(
            f"memory of a long run: {memory[0] / 1e6:.1f} MB after a quarter, {max(memory) / 1e6:.1f} MB at most",
            flush=True,
        )
        while time.monotonic() < end:
            interval, rows = random_number.choice((0.7, 2, 5)), random_number.choice((0.05, 0.2, 1))
            overrides = [*PERFORATION, f"output.interval={interval} us", f"output.history={rows} us"]
            whole = whole_run(program, "whole", overrides, random_number.randrange(1, 5))
            pieces += run_in_pieces(program, "out", overrides, random_number)
            runs += 1
            assert differences(whole, program.folder / "out") == [], (seed, runs)
            for folder in ("whole", "out"):
                for path in (program.folder / folder).iterdir():
                    path.unlink()
            print(f"{runs} runs in {pieces} pieces", flush=True)
    print(f"{runs} runs in {pieces} pieces alike, seed {seed}")


main()
