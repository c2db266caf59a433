"""A perforation computed by 1 to 4 ranks, also when columns change ranks on the way, leaves the same files:
rank_invariance.py WEAVEFRONT MPIEXEC H5DIFF SCENE"""

import subprocess
import sys
import tempfile
from pathlib import Path

import runs


# The third ply has unequal yarns of scattered strength.
UNEVEN = [
    "--set",
    "fabrics.uneven={library: kevlar_km2_s706, contact_thickness: 0.2 mm, crimp: {fill: 0.5 %, warp: 2 %},"
    " failure: {strain: 3 %, scatter: {weibull_modulus: 10, gauge_length: 1 mm}}}",
    "--set",
    "target.plies.2.fabric=uneven",
]


def check_perforated(output):
    """The scene does what it is here for: all plies break, elements go, the last ply is reached through the
    others, the projectile leaves."""
    summary, rows = runs.summary(output), runs.history(output)
    breaks = summary["first_break"]
    print("first breaks:", breaks, "eroded:", summary["eroded_elements"], "contact:", rows[-1]["contact"])
    assert all(time is not None for time in breaks), "a ply is whole"
    assert breaks[-1] == max(breaks) and breaks[-1] > min(breaks)
    assert summary["eroded_elements"] >= 4 * 4 and summary["residual_velocity"] > 100
    # Ahead of the undeformed last ply by more than the fabric still moves, and no longer slowed.
    assert rows[-1]["projectile_z"] > 10e-3
    assert abs(rows[-1]["contact_fz"]) < 0.05 * max(abs(row["contact_fz"]) for row in rows)


def main():
    weavefront, mpiexec, h5diff, scene = sys.argv[1:]
    program = runs.Program(weavefront, mpiexec)
    with tempfile.TemporaryDirectory() as folder:
        outputs = [Path(folder) / f"on {ranks} of them" for ranks in range(1, 5)]
        for ranks, output in enumerate(outputs, start=1):
            program.run(scene, output, ranks=ranks, options=UNEVEN)
        outputs.append(Path(folder) / "on 3 of them, rebalanced")
        program.run(scene, outputs[-1], ranks=3, options=[*UNEVEN, "--rebalance", "0"])
        assert "rebalanced" in (outputs[-1] / "run.log").read_text()
        check_perforated(outputs[0])
        for output in outputs[1:]:
            assert runs.history_bytes(output) == runs.history_bytes(
                outputs[0]
            ), f"{output}: history.csv differs"
            subprocess.run(
                [h5diff, str(outputs[0] / "results.vtkhdf"), str(output / "results.vtkhdf")], check=True
            )


main()
