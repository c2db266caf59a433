"""What a target takes of memory is what is said of it, and all ranks of a machine are counted: memory.py
WEAVEFRONT MPIEXEC"""

import math
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from small_run import Program, sets

PLIES = (10, 8000)  # of one element each, so that nodes and plies count


def call(command):
    """What a command prints, and the megabytes that it took."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    text = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 0, text
    return text, usage.ru_maxrss * 1024 / 1e6


def check(program, overrides):
    """Megabytes that `check` states, and those that it took."""
    text, taken = call([program.weavefront, "check", program.folder / "scene.yaml", *sets(overrides)])
    return float(re.search(r"memory +up to ([0-9.]+) MB", text).group(1)), taken


def check_plies(program, plies):
    return check(
        program,
        [f"target.plies={{count: {plies}, fabric: a, spacing: 0.25 mm}}", "target.mesh={center: 20 mm}"],
    )


def check_checkpoints(program):
    """A run that writes checkpoints takes no more than is said, beside the program itself."""
    short = ["time.end=0.08 us", "output.interval=0", "output.history=0.08 us"]
    fine = [*short, "target.mesh={center: 0.1 mm, edge: 0.1 mm}"]
    said, _ = check(program, fine)
    options = ["--checkpoint-every", "2 steps", "--overwrite"]
    _, small = call(program.command("checkpoints", short, options=options))
    _, large = call(program.command("checkpoints", fine, options=options))
    print(f"a run with checkpoints: {large - small:.1f} MB more, {said:.1f} MB said")
    assert 0.5 * said < large - small < said


def available():
    """Bytes that the kernel has available; a limit of a container may be lower."""
    return 1024 * int(re.search(r"MemAvailable: +(\d+) kB", Path("/proc/meminfo").read_text()).group(1))


def main():
    weavefront, mpiexec = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        program = Program(weavefront, mpiexec, Path(scratch))
        (few_said, few), (many_said, many) = (check_plies(program, plies) for plies in PLIES)
        print(f"{many - few:.1f} MB more, {many_said - few_said:.1f} MB said")
        assert many - few < many_said - few_said
        check_checkpoints(program)

        # Half as much again as there is, so that each rank alone would find enough.
        elements = 1.5 * available() / 500
        size = 20 / math.sqrt(elements / 2)
        (error,) = program.run("out", [f"target.mesh={{center: {size:.6f} mm}}"], ranks=4, status=3)
        print(error)
        assert "on the 4 of 4 ranks that run on one machine" in error, error
        assert not (Path(scratch) / "out").exists()


main()
