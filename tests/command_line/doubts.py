"""What is allowed but hardly meant is said by `check`, which otherwise says nothing of the kind: doubts.py WEAVEFRONT SCENE"""

import subprocess
import sys

DOUBTFUL = {
    "fabrics.kevlar129.yarn.area=6.48 mm^2": "weigh 2.053e+04 g/m2",
    "fabrics.kevlar129.thickness=0.82 m": "rise and fall by 820 mm every 0.909 mm",
    "projectile.diameter=5.38 Mm": "the projectile is 5.38e+09 mm across, the target 203.2 mm",
    "projectile.position=[0 m, 0 m, -1 m]": "needs 3745 us to the first ply, the run ends at 200 us",
    "projectile.velocity.2=26700 m/s": "more than the 0.1417 mm that a ply is thick",
}
NARROW_FRAME = ["--set", "target.edges.y=frame", "--set", "target.frame={opening: {y: 4 mm}}"]
TOO_FINE = ["--set", "target.mesh={center: 0.005 mm, edge: 0.005 mm}"]


def check(program, scene, *options):
    done = subprocess.run([program, "check", scene, *options], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done
    return done.stdout


def main():
    program, scene = sys.argv[1:3]
    assert "warning" not in check(program, scene)
    for override, phrase in DOUBTFUL.items():
        warnings = [line for line in check(program, scene, "--set", override).splitlines() if line.startswith("warning: ")]
        print(warnings)
        assert any(phrase in line for line in warnings), override
    assert "the frame's opening is 4 mm along y, less than the 5.38 mm of the projectile" in check(program, scene, *NARROW_FRAME)
    assert "time step  not computed: the target does not fit into the" in check(program, scene, *TOO_FINE)
    done = subprocess.run([program, "run", scene, *TOO_FINE], capture_output=True, text=True, timeout=60)
    print(done.stderr)
    assert done.returncode == 3 and "use more machines or a coarser mesh" in done.stderr, done


main()
