"""Runs go on and on: soak.py WEAVEFRONT MPIEXEC [MINUTES [SEED]], 30 minutes by default.

Each run has output settings by chance. It is left and restarted by chance, on random numbers of ranks, with and without rebalancing, and is compared with
an uninterrupted run. Beside it, a small run of 200,000 steps must not take more and more memory."""

import os
import random
import signal
import sys
import tempfile
import time
from pathlib import Path

from perforation import PERFORATION, Program, differences, processes_of, start, whole_run

SIGNALS = (signal.SIGTERM, signal.SIGUSR1, signal.SIGUSR2)

# Some 200,000 steps of few elements that touch and let go: a ball bounces on a net.
BOUNCING = ("target.mesh={center: 5 mm, edge: 5 mm}", "time.end=24 ms", "output.interval=2 ms", "output.history=20 us", "projectile.velocity=[0, 0, 3 m/s]")


def resident(pid):
    """Memory of a process, bytes."""
    pages = int(Path(f"/proc/{pid}/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


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
        bouncing = start(program, "bouncing", BOUNCING, 1, [])
        memory = []
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
            if bouncing.poll() is None:
                memory.append(resident(bouncing.pid))
            print(f"{runs} runs in {pieces} pieces, memory {memory[-1] / 1e6:.1f} MB" if memory else f"{runs} runs", flush=True)
        bouncing.send_signal(signal.SIGTERM)
        bouncing.communicate(timeout=60)
    if len(memory) > 4:
        assert memory[-1] < 1.05 * memory[len(memory) // 4], memory
    print(f"{runs} runs in {pieces} pieces alike, seed {seed}; memory of a long run {memory[0] / 1e6:.1f} to {memory[-1] / 1e6:.1f} MB")


main()
