"""Checkpoints that were cut or changed are refused by name: corruption.py WEAVEFRONT MPIEXEC [COUNT [SEED]]

With 200, every region of the file is tried: bits flip and the file is cut, at random places."""

import random
import shutil
import sys
import tempfile
from pathlib import Path

from perforation import PERFORATION, Program, differences, whole_run


def damaged(content, kind, random_number):
    """The content with one bit turned, or cut, or with a stretch of zeros."""
    place = random_number.randrange(len(content))
    if kind == "bit":
        return (
            content[:place] + bytes([content[place] ^ 1 << random_number.randrange(8)]) + content[place + 1 :]
        )
    if kind == "cut":
        return content[:place]
    length = min(random_number.randrange(1, 5000), len(content) - place)
    changed = content[:place] + bytes(length) + content[place + length :]
    return changed if changed != content else damaged(content, "bit", random_number)


def main():
    weavefront, mpiexec, *rest = sys.argv[1:]
    count, seed = (int(rest[0]) if rest else 24), (int(rest[1]) if len(rest) > 1 else 1)
    random_number = random.Random(seed)
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        program = Program(weavefront, mpiexec, folder)
        whole = whole_run(program)
        program.run("out", [*PERFORATION, "time.end=24 us"], 1, ["--checkpoint-every", "150 steps"])
        checkpoint = folder / "out/checkpoint.h5"
        content = checkpoint.read_bytes()
        before = {path.name: path.read_bytes() for path in (folder / "out").iterdir()}
        one = folder / "damaged.h5"
        for number in range(count):
            kind = ("bit", "bit", "cut", "zeros")[number % 4]
            one.write_bytes(damaged(content, kind, random_number))
            (error,) = program.run("out", PERFORATION, 1 + number % 8 // 7, ["--restart", str(one)], status=2)
            assert "--restart: no checkpoint can be used: " in error and str(one) in error, (
                number,
                kind,
                error,
            )
        for path in ("missing.h5", "scene.yaml", "whole/results.vtkhdf"):
            (error,) = program.run("out", PERFORATION, 1, ["--restart", str(folder / path)], status=2)
            assert str(folder / path) in error, error
        assert {path.name: path.read_bytes() for path in (folder / "out").iterdir()} == before

        # The older one is taken, and the log says why.
        checkpoint.write_bytes(content[:-7])
        program.run("out", PERFORATION, 2, ["--restart", "auto"])
        log = (folder / "out/run.log").read_text()
        assert (
            f"warning: a checkpoint is passed over: {checkpoint} " in log
            and "  restart       from " + str(folder / "out/checkpoint.previous.h5") in log
        )
        assert differences(whole, folder / "out") == []
        shutil.rmtree(folder / "out")
    print(f"{count} damaged checkpoints refused, seed {seed}")


main()
