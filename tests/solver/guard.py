"""A run that cannot go on stops with status 1, one message and readable files:
guard.py WEAVEFRONT MPIEXEC SCENE YARN_SCENE"""

import re
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

import runs


def check_files(output):
    """All files are whole, the last frame shows the state at the stop, and nothing in them is NaN or
    infinite."""
    summary, rows = runs.summary(output), runs.history(output)
    assert summary["status"] == "stopped", summary["status"]
    assert rows and all(np.isfinite(list(row.values())).all() for row in rows)
    with h5py.File(output / "results.vtkhdf") as file:
        steps = file["VTKHDF/Steps"]
        frames = int(steps.attrs["NSteps"])
        times = steps["Values"][:frames]
        assert times[-1] == summary["time"] and times[-1] >= rows[-1]["time"], (times[-1], summary["time"])

        def check(name, item):
            if isinstance(item, h5py.Dataset) and item.dtype.kind == "f":
                assert np.isfinite(item[()]).all(), f"{name} is not finite"

        file.visititems(check)
    return summary


def check_stop(program, scene, output, overrides, cause, ranks=1):
    """The run stops because of `cause` and says so once."""
    lines = program.run(scene, output, overrides, ranks, status=1).splitlines()
    lines = [line for line in lines if line.startswith(("warning: ", "weavefront: "))] if ranks > 1 else lines
    errors = [line for line in lines if not line.startswith("warning: ")]
    print(errors)
    assert len(errors) == 1 and cause in errors[0], lines
    assert check_files(output)["reason"] in errors[0]
    assert re.search(
        r"; it is worst in element \d+ \(ply \d+, at x = \S+ mm, y = \S+ mm\): .+; try .+", errors[0]
    ), errors
    return errors[0]


def main():
    program, (scene, yarn) = runs.Program(sys.argv[1], sys.argv[2]), sys.argv[3:]
    with tempfile.TemporaryDirectory() as folder:
        balance = ["limits.energy_error=1e-9"]
        check_stop(program, scene, Path(folder) / "balance", balance, "energy balance")
        # Straight elastic yarns at 1.2 times their bound, with nothing that takes energy and contact too soft
        # to bind the step: past the limit of stability.
        unstable = [
            "time.safety=1.2",
            "fabrics.kevlar129.thickness=0",
            "fabrics.kevlar129.elastic.viscosity=0",
            "fabrics.kevlar129.failure=",
            "fabrics.kevlar129.lateral=",
            "damping=0",
            "target.plies={count: 1, fabric: kevlar129}",
            "target.mesh={center: 2 mm}",
            "contact.projectile={stiffness: 1e11 N/m^3, unloading: 1}",
        ]
        told = check_stop(program, scene, Path(folder) / "unstable", unstable, "energy balance")
        assert re.search(r": the time step of \S+ ns is 1\.\d+ times its bound", told) and told.endswith(
            "; try time.safety of at most 1"
        ), told
        assert (
            check_stop(program, scene, Path(folder) / "on three ranks", unstable, "energy balance", 3) == told
        )
        # A heavy projectile hands over a millionth of its energy, and it is of this that energy is lost.
        check_stop(
            program, yarn, Path(folder) / "heavy", ["time.safety=1.1"], "that the projectile has handed over"
        )
        # Rows at the ends of the run only.
        check_stop(
            program,
            yarn,
            Path(folder) / "seldom",
            [*balance, "time.end=60us", "output.history=60us"],
            "energy balance",
        )
        assert runs.summary(Path(folder) / "seldom")["steps"] == 1000


main()
