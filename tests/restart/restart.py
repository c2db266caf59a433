"""A run that goes on from a checkpoint writes the files of an uninterrupted one, on any number of ranks:
restart.py WEAVEFRONT MPIEXEC"""

import sys
import tempfile
from pathlib import Path

from perforation import MIXED, PERFORATION, Program, differences, summary, whole_run

STEPS = "--checkpoint-every", "150 steps"


def goes_on_on_any_ranks(program, whole):
    """From ranks to ranks, one after the other, with columns that move between them."""
    for first, then in ((1, 3), (4, 2)):
        output = f"{first} to {then}"
        # The wall time is over at the first step.
        (error,) = program.run(output, PERFORATION, first, ["--walltime", "1 s"], status=4)
        assert "the wall time of 1 s is nearly over: a checkpoint was written; to go on: " in error, error
        assert f"--output '{program.folder / output}' --restart auto" in error, error
        assert summary(program.folder / output)["status"] == "interrupted"
        program.run(output, PERFORATION, then, ["--restart", "auto", *STEPS, "--rebalance", "0"])
        assert differences(whole, program.folder / output) == [], output
        # The last checkpoint is that of some step before the end: from there again, with all that was written
        # since.
        program.run(output, PERFORATION, first, ["--restart", "auto"])
        assert differences(whole, program.folder / output) == [], output
        program.run(
            output, PERFORATION, then, ["--restart", str(program.folder / output / "checkpoint.previous.h5")]
        )
        assert differences(whole, program.folder / output) == [], output
        log = (program.folder / output / "run.log").read_text()
        assert log.count("  restart       from ") == 3 and log.count("Finished at t = ") == 3, log


def all_formulations_go_on(program):
    whole = whole_run(program, "mixed", MIXED)
    program.run("in two", [*MIXED, "time.end=12 us"], 2, ["--checkpoint-every", "50 steps"])
    program.run("in two", MIXED, 3, ["--restart", "auto"])
    assert differences(whole, program.folder / "in two") == []


def end_and_intervals_may_change(program, whole):
    shorter = [*PERFORATION, "time.end=30 us", "output.interval=7 us", "output.history=3 us"]
    program.run("longer", shorter, 2, STEPS)
    program.run(
        "longer", [*PERFORATION, "output.interval=7 us", "output.history=3 us"], 1, ["--restart", "auto"]
    )
    program.run("at once", [*PERFORATION, "output.interval=7 us", "output.history=3 us"])
    assert differences(program.folder / "at once", program.folder / "longer") == []
    program.run("finer", [*PERFORATION, "time.end=30 us"], 1, STEPS)
    program.run("finer", [*PERFORATION, "output.history=0.1 us"], 1, ["--restart", "auto"])
    rows = (program.folder / "finer/history.csv").read_bytes().splitlines()
    rows_of_whole = (whole / "history.csv").read_bytes().splitlines()
    assert len(rows) > len(rows_of_whole) and set(rows_of_whole) <= set(rows)


def the_past_may_not(program):
    output = program.folder / "refused"
    program.run("refused", [*PERFORATION, "time.end=20 us"], 1, STEPS)
    before = {path.name: path.read_bytes() for path in output.iterdir()}
    errors = program.run(
        "refused",
        [*PERFORATION, "projectile.mass=0.8 g", "contact.spacing=0.3 mm"],
        2,
        ["--restart", "auto"],
        status=2,
    )
    checkpoint = output / "checkpoint.h5"
    assert (
        f"--restart: projectile.mass: found 0.0008 kg, allowed is that of {checkpoint}, 0.0009 kg" in errors
    ), errors
    assert (
        any(
            error.startswith("--restart: contact.spacing: found 0.0003 m, allowed is that of ")
            for error in errors
        )
        and len(errors) == 2
    )
    (error,) = program.run("refused", [*PERFORATION, "time.end=4 us"], 1, ["--restart", "auto"], status=2)
    assert "--restart: time.end: found 4 us, allowed is a time after that of " in error, error
    (error,) = program.run("refused", PERFORATION, 1, status=2)
    assert (
        "checkpoint.h5" in error and "--restart auto goes on with it, --overwrite replaces it" in error
    ), error
    assert {path.name: path.read_bytes() for path in output.iterdir()} == before
    (error,) = program.run("nothing", PERFORATION, 1, ["--restart", "auto"], status=2)
    assert "holds no run that could go on" in error and not (program.folder / "nothing").exists(), error
    # Rows and frames that are not those of the checkpoint.
    (output / "history.csv").write_bytes(before["history.csv"].replace(b"1", b"2", 1))
    (error,) = program.run("refused", PERFORATION, 1, ["--restart", "auto"], status=3)
    assert "history.csv cannot be continued: its rows are not those of the checkpoint" in error, error
    (output / "history.csv").write_bytes(before["history.csv"])
    (output / "results.vtkhdf").unlink()
    (error,) = program.run("refused", PERFORATION, 1, ["--restart", "auto"], status=3)
    assert "results.vtkhdf cannot be continued" in error, error
    assert (output / "history.csv").read_bytes() == before["history.csv"]


def main():
    weavefront, mpiexec = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        program = Program(weavefront, mpiexec, Path(scratch))
        whole = whole_run(program)
        goes_on_on_any_ranks(program, whole)
        all_formulations_go_on(program)
        end_and_intervals_may_change(program, whole)
        the_past_may_not(program)


main()
