"""`weavefront cell` and `weavefront yarn` from the files that they read to the files that they write. Usage:
commands.py WEAVEFRONT SCENE"""

import csv
import math
import os
import subprocess
import sys
import tempfile

E1, KA, TAU = 96e9, 192e9, 35e6 / 384e9
RATES = [0.001, 10, 30, 50, 70, 100, 150, 200, 300, 500]
FAILURES = {
    0.001: (3.300, 20),
    10: (3.391, 20),
    30: (3.573, 20),
    50: (3.756, 20),
    70: (3.937, 20),
    100: (4.202, 20),
    150: (4.101, 19),
    200: (3.803, 19),
    300: (3.442, 19),
    500: (3.134, 19),
}
CELL_COLUMNS = (
    "time,lambda_fill,lambda_warp,theta,h_fill,strain_fill,strain_warp,stress_fill,stress_warp,contact_factor,stress_xx,stress_yy,"
    "stress_xy,broken_fill,broken_warp"
).split(",")


def call(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=60)


def rows_of(path):
    with open(path) as file:
        reader = csv.DictReader(file)
        return reader.fieldnames, [{name: float(value) for name, value in row.items()} for row in reader]


def check_yarn(program, scene):
    result = call(program, "yarn", scene, "--rates", ",".join(map(str, RATES)), "--out", "yarn.csv")
    assert result.returncode == 0, result
    columns, rows = rows_of("yarn.csv")
    assert columns == ["rate", "time", "strain", "stress", "failure"], columns
    for rate in RATES:
        curve = [row for row in rows if row["rate"] == rate]
        assert 100 < len(curve) <= 402, len(curve)
        for row in curve:
            time = row["time"]
            closed = E1 * rate * time + (KA - E1) * rate * TAU * -math.expm1(-time / TAU)
            # exact at any step but for rounding, at most 1e-16 of Ka in each of 10^5 steps
            assert abs(row["stress"] - closed) < 1e-11 * KA, (row, closed)
        strain, criterion = FAILURES[rate]
        assert curve[-1]["failure"] == criterion and all(row["failure"] == 0 for row in curve[:-1]), rate
        assert abs(100 * curve[-1]["strain"] / strain - 1) < 2e-4, (rate, curve[-1])  # four digits are given


def check_cell(program, scene):
    angle = math.radians(5)
    with open("path.csv", "w") as file:
        file.write("time,F11,F12,F21,F22\r\n1e-3,1,0,0,1\r\n")
        for i in range(1, 101):  # equibiaxial stretch in a turning frame
            stretch, turn = 1 + 3e-4 * i, angle * i
            c, s = stretch * math.cos(turn), stretch * math.sin(turn)
            file.write(
                f"{1e-3 + 1e-6 * i!r},{c!r}, {-s!r},{s!r},+{c!r}\n"
                if c >= 0
                else f"{1e-3 + 1e-6 * i!r},{c!r},{-s!r},{s!r},{c!r}\n"
            )
    result = call(program, "cell", scene, "--path", "path.csv", "--out", "cell.csv", "--fabric", "kevlar129")
    assert result.returncode == 0, result
    columns, rows = rows_of("cell.csv")
    assert columns == CELL_COLUMNS, columns
    assert len(rows) == 101 and rows[0]["stress_xx"] == 0 and rows[0]["lambda_fill"] == 1
    last = rows[-1]
    half, height = 0.909e-3 / 2, 0.82e-3 / 4
    strain = math.hypot(1.03 * half, height) / math.hypot(half, height) - 1
    assert abs(last["strain_fill"] - strain) < 1e-14 and abs(last["strain_warp"] - strain) < 1e-14
    assert abs(last["lambda_warp"] - 1.03) < 1e-14 and abs(last["theta"] - math.pi / 4) < 1e-14
    assert abs(last["h_fill"] - height) < 1e-12 * height  # nothing but rounding tells the yarns apart
    # Cauchy stress: n/lambda^2 of either yarn over t_e
    slope = 1.03 * half / math.hypot(1.03 * half, height)
    stress = last["stress_fill"] * 6.48e-8 * slope / 0.909e-3 / 1.03 / (0.204 / 1440)
    assert abs(last["stress_xx"] / stress - 1) < 1e-12 and abs(last["stress_yy"] / stress - 1) < 1e-12, (
        last,
        stress,
    )
    assert abs(last["stress_xy"]) < 1e-6 * stress
    assert last["broken_fill"] == 0 and last["contact_factor"] == 0


REFUSALS = [
    (
        "time,F1l,F12,F21\n",
        [
            "1:6: found column 'F1l', allowed the columns time,F11,F12,F21,F22, in this order, did you mean 'F11'?",
            "1:17: found no column 'F22'",
        ],
    ),
    ("time,F11,F12,F21,F22\n", ["1:1: found no row"]),
    ("", ["1:1: found nothing"]),
    ("time,F11,F12,F21,F22\n0,1,0.1,0,1\n", ["2:3: found a deformed first row"]),
    (
        "time,F11,F12,F21,F22\n0,1,0,0,1\n1, 1,x,0,1\n2,1,0,1\n0,1,0,0,1\n3,-1,0,0,1\n4,nan,0,0,1\n",
        [
            "3:6: F12: found 'x', allowed a finite number",
            "4:1: found 4 fields, allowed 5",
            "5:1: time: found 0, allowed more than the 0",
            "6:3: found F with determinant -1",
            "7:3: F11: found 'nan'",
        ],
    ),
    (
        "time,F11,F12,F21,F22\n0,1,0,0,1\n1,1e300,0,0,1\n2,1,0,0,-inf\n3,1,0,0,1e-9\n4,1,0x1,0,1\n",
        [
            "3:3: found a stretch of 1e+300 of the fill yarns, allowed one from 0.01 to 100",
            "4:9: F22: found '-inf', allowed a finite number",
            "5:5: found a stretch of 1e-09 of the warp yarns, allowed one from 0.01 to 100",
            "6:5: F12: found '0x1', allowed a finite number",
        ],
    ),
    (
        "time,F11,F12,F21,F22\n0,1,0,0,1\n1,1,0,0,1,\n",
        ["3:1: found 6 fields, allowed 5: time,F11,F12,F21,F22"],
    ),
]


def check_far_apart(program, scene):
    """A curve has its hundred rows also where the yarn breaks long before both strains have been reached."""
    result = call(
        program,
        "yarn",
        scene,
        "--rates",
        "1e-3",
        "--out",
        "yarn.csv",
        "--set",
        "fabrics.kevlar129.failure.static_strain=0.1 %",
        "--set",
        "fabrics.kevlar129.failure.hooke_strain=100 %",
    )
    assert result.returncode == 0, result
    rows = rows_of("yarn.csv")[1]
    assert (
        100 < len(rows) < 402 and rows[-1]["failure"] == 20 and abs(rows[-1]["strain"] / 1e-3 - 1) < 1e-3
    ), (len(rows), rows[-1])


def check_unequal(program, scene):
    """Fill and warp have curves of their own, and the cell has both."""
    unequal = [
        "--set",
        "fabrics.kevlar129.elastic={modulus: {fill: 96 GPa, warp: 80 GPa}}",
        "--set",
        "fabrics.kevlar129.failure={strain: {fill: 3 %, warp: 4 %}}",
    ]
    for yarn, modulus, strain in (("fill", 96e9, 0.03), ("warp", 80e9, 0.04)):
        result = call(program, "yarn", scene, "--rates", "1", "--yarn", yarn, "--out", "yarn.csv", *unequal)
        assert result.returncode == 0, result
        last = rows_of("yarn.csv")[1][-1]
        # the increment is 2e-5 of the failure strain
        assert abs(last["strain"] / strain - 1) < 3e-5 and last["failure"] == 20, (yarn, last)
        assert abs(last["stress"] / (modulus * last["strain"]) - 1) < 1e-12, (yarn, last)
    with open("path.csv", "w") as file:
        file.write("time,F11,F12,F21,F22\n0,1,0,0,1\n1e-6,1.01,0,0,1.02\n")
    straight = ["--set", "fabrics.kevlar129.thickness=0", "--set", "fabrics.kevlar129.friction=0"]
    result = call(program, "cell", scene, "--path", "path.csv", "--out", "cell.csv", *unequal, *straight)
    assert result.returncode == 0, result
    last = rows_of("cell.csv")[1][-1]
    assert abs(last["stress_fill"] / (96e9 * 0.01) - 1) < 1e-12, last
    assert abs(last["stress_warp"] / (80e9 * 0.02) - 1) < 1e-12, last


def check_excel(program, scene):
    """Saved by a spreadsheet: a byte order mark, line ends of two characters, blanks."""
    with open("path.csv", "wb") as file:
        file.write("\ufefftime,F11,F12,F21,F22\r\n0,1,0,0,1\r\n1e-6, 1.001,0,0,\u00a01\r\n".encode())
    result = call(program, "cell", scene, "--path", "path.csv", "--out", "cell.csv")
    assert result.returncode == 0 and len(rows_of("cell.csv")[1]) == 2, result


def check_refusals(program, scene):
    for text, findings in REFUSALS:
        with open("bad.csv", "w") as file:
            file.write(text)
        result = call(program, "cell", scene, "--path", "bad.csv", "--out", "never.csv")
        lines = result.stderr.splitlines()
        assert result.returncode == 2 and len(lines) == len(findings), (text, result)
        for line, finding in zip(lines, findings):
            assert f"bad.csv:{finding}" in line, (line, finding)
    for arguments, finding in [
        (["--rates", "0,-1"], "--rates: found '0', allowed positive"),
        (["--rates", "ten"], ""),
        (["--rates", "5", "--fabric", "kevlar128"], "did you mean 'kevlar129'?"),
        (["--rates", "5", "--yarn", "weft"], "--yarn: found 'weft', allowed fill or warp"),
    ]:
        result = call(program, "yarn", scene, "--out", "never.csv", *arguments)
        assert result.returncode == 2 and finding in result.stderr, (arguments, result)
    # They took 2^31 steps and more, which came out as a curve of one row.
    result = call(
        program,
        "yarn",
        scene,
        "--rates",
        "5",
        "--out",
        "never.csv",
        "--set",
        "fabrics.kevlar129.failure.hooke_strain=5e-7",
    )
    assert (
        result.returncode == 2
        and "found failure strains (static_strain, hooke_strain) of 0.033 and 5e-07, which take"
        in result.stderr
    ), result
    result = call(program, "yarn", scene, "--rates", "5", "--out", "no/such/folder.csv")
    assert result.returncode == 3, result
    assert sorted(os.listdir()) == ["bad.csv", "cell.csv", "path.csv", "yarn.csv"], os.listdir()


def main():
    program, scene = (os.path.abspath(argument) for argument in sys.argv[1:3])
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        check_yarn(program, scene)
        check_far_apart(program, scene)
        check_cell(program, scene)
        check_unequal(program, scene)
        check_excel(program, scene)
        check_refusals(program, scene)


if __name__ == "__main__":
    main()
