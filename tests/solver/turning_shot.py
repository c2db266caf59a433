"""A spinning, oblique shot with friction and a later one leave the same files on any number of ranks and after a
restart:
turning_shot.py WEAVEFRONT MPIEXEC H5DIFF SCENE"""

import subprocess
import sys
import tempfile
from pathlib import Path

import runs


def check_shot(output):
    """The shot does what it is here for: the projectile turns, friction and clamps take energy, yarns break,
    and the energy closes."""
    rows = runs.history(output)
    friction = [row["contact_friction"] for row in rows]
    print("contact friction:", friction[-1], "energy error:", max(abs(row["energy_error"]) for row in rows))
    assert friction[-1] > 0.1, "J"
    assert all(after >= before for before, after in zip(friction, friction[1:])), "friction gave energy"
    assert abs(rows[-1]["projectile_wx"]) > 100 and rows[-1]["projectile_wz"] != rows[0]["projectile_wz"]
    assert rows[-1]["broken_yarns"] > 0
    assert rows[-1]["projectile2_vz"] < 0.9 * rows[0]["projectile2_vz"], "the second one hardly hit"
    assert max(abs(row["energy_error"]) for row in rows) < 0.01
    outcomes = runs.summary(output)["projectiles"]
    assert [outcome["residual_velocity"] for outcome in outcomes] == [
        rows[-1]["projectile_vz"],
        rows[-1]["projectile2_vz"],
    ]


def main():
    weavefront, mpiexec, h5diff, scene = sys.argv[1:]
    program = runs.Program(weavefront, mpiexec)
    with tempfile.TemporaryDirectory() as folder:
        whole, *others = (Path(folder) / name for name in ("on 1", "on 3", "from 1 to 2"))
        program.run(scene, whole)
        check_shot(whole)
        program.run(scene, others[0], ranks=3)
        program.run(scene, others[1], ["time.end=12 us"], options=["--checkpoint-every", "100 steps"])
        subprocess.run(
            [mpiexec, "-n", "2", weavefront, "run", scene, "--output", others[1], "--restart", "auto"],
            check=True,
            capture_output=True,
        )
        for output in others:
            assert runs.history_bytes(output) == runs.history_bytes(whole), f"{output}: history.csv differs"
            subprocess.run(
                [h5diff, str(whole / "results.vtkhdf"), str(output / "results.vtkhdf")], check=True
            )


main()
