#!/usr/bin/python3
"""What weavefront-plot refuses, and how: test_refusals.py PATH/TO/weavefront-plot."""
import json
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

from plotter import PACKAGES, OnFolder
from synthetic_run import write_run

STUDY = Path(__file__).resolve().parents[2] / "examples" / "studies" / "waves" / "study.json"
YARN = "rate,time,strain,stress,failure\n1,0,0,0,0\n1,0.03,0.03,3e9,{failure}\n"


class OnRun(OnFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.run_folder = cls.folder / "run"
        write_run(cls.run_folder, count=4, plies=2, frames=3)


class Usage(OnRun):
    CASES = (
        ("give the folder of a run", ()),
        ("--colour", ("RUN", "--colour", "red")),
        ("--only: 'histroy' is none of history,", ("RUN", "--only", "histroy")),
        ("--only: 'history,,section' has an empty item", ("RUN", "--only", "history,,section")),
        ("'30' is not a number with one of the units", ("RUN", "--times", "30")),
        ("'1e999us' is not a number", ("RUN", "--times", "1e999us")),
        ("--times: empty", ("RUN", "--times", ",")),
        ("must be greater than zero", ("RUN", "--window", "0mm")),
        ("--window: '1e9m' is not from 1 um to 1000 m", ("RUN", "--window", "1e9m")),
        ("--plies: '5-3' is no ply", ("RUN", "--plies", "1,5-3")),
        ("--plies: '0' is no ply", ("RUN", "--plies", "0")),
        ("--view: 'front' is none of back-face,", ("RUN", "--view", "front")),
        ("--view: '30,91' is none of", ("RUN", "--view", "30,91")),
        ("--view: 'nan,0' is none of", ("RUN", "--view", "nan,0")),
        ("--animate: invalid choice: 'avi'", ("RUN", "--animate", "avi")),
        ("--animate: --only leaves out deformed", ("RUN", "--animate", "gif", "--only", "history")),
        (
            "--window: --only leaves out deformed and section and contour",
            ("RUN", "--window", "1cm", "--only", "history"),
        ),
        ("not both", ("RUN", "--yarn", "curves.csv")),
        ("give one of RUN, --yarn, --study and --v50", ("RUN", "--study", "DIR")),
        ("--field does not go with --yarn", ("--yarn", "curves.csv", "--field", "height")),
        ("--no-debris does not go with --study", ("--study", "DIR", "--no-debris")),
        ("--output: 'y.jpg' must end in one of .png", ("--yarn", "curves.csv", "--output", "y.jpg")),
        (
            "--output: 'y.png' does not end in .svg",
            ("--yarn", "curves.csv", "--output", "y.png", "--format", "svg"),
        ),
        ("--output: empty", ("RUN", "--output", "")),
    )

    def test_is_checked_before_any_file_is_read(self):
        for part, arguments in self.CASES:
            with self.subTest(arguments=arguments):
                self.refused(
                    2, part, *arguments, cwd=self.folder
                )  # there is neither RUN nor DIR nor curves.csv

    def test_is_checked_before_anything_is_loaded(self):
        check = (
            "import sys; sys.path[:0] = sys.argv[1:]; sys.argv = ['weavefront-plot', 'RUN', '--times', '30']\n"
            "from weavefront_plot.command import main\nassert main() == 2\n"
            "assert not {'numpy', 'h5py', 'matplotlib'} & set(sys.modules), 'seconds on a slow disk'"
        )
        done = subprocess.run(
            [sys.executable, "-B", "-c", check, *PACKAGES], capture_output=True, text=True, check=False
        )
        self.assertEqual(done.returncode, 0, done.stderr)


class Missing(OnRun):
    def test_files(self):
        self.refused(3, "no such folder", self.folder / "nowhere")
        self.refused(3, "not a folder", self.run_folder / "history.csv")
        empty = self.folder / "empty"
        empty.mkdir()
        self.refused(3, "history.csv: No such file", empty)
        self.refused(3, "results.vtkhdf: no such file", empty, "--only", "section")
        self.refused(3, "none.csv: No such file", self.run_folder, "--measured", self.folder / "none.csv")
        self.refused(3, "none.csv: No such file", "--yarn", self.folder / "none.csv")
        self.refused(3, "study.json: No such file", "--study", empty)

    def test_files_that_are_none(self):
        odd = self.folder / "odd"
        odd.mkdir()
        os.mkfifo(odd / "history.csv")
        self.refused(3, "history.csv: not a file", odd, "--only", "history", timeout=30)
        os.mkfifo(odd / "results.vtkhdf")
        self.refused(3, "results.vtkhdf: not a file", odd, "--only", "section", timeout=30)
        self.refused(2, "/dev/zero: a device", self.run_folder, "--measured", "/dev/zero", timeout=30)

    def test_what_is_asked_for(self):
        self.refused(2, "no cell array 'spin'; it has ply, strain_fill", self.run_folder, "--field", "spin")
        self.refused(2, "no cell array 'joined'", self.run_folder, "--no-debris")
        self.refused(
            2,
            "no fabric within 0.001 mm of the impact",
            self.run_folder,
            "--only",
            "deformed",
            "--window",
            "1um",
        )


def without(name):
    """Takes an object out of results.vtkhdf."""

    def change(file):
        del file[name]

    return change


def with_value(name, place, value):
    """Changes a value of an array."""

    def change(file):
        file[name][place] = value

    return change


def with_array(name, **keywords):
    """Puts another array in the place of one."""

    def change(file):
        del file[name]
        file.create_dataset(name, **keywords)

    return change


def with_frames(value):
    """Changes NSteps."""

    def change(file):
        file["VTKHDF/Steps"].attrs["NSteps"] = value

    return change


def with_absurd_connectivity(file):
    """Gives Connectivity more rows than any machine has memory for."""
    with_array("VTKHDF/Connectivity", shape=(2**60,), dtype="i8", chunks=(1024,))(file)
    file["VTKHDF/NumberOfConnectivityIds"][0] = 2**37


POINTS, MOVED, TIMES = "VTKHDF/Points", "VTKHDF/PointData/displacement", "VTKHDF/Steps/Values"


class DamagedResults(OnRun):
    CASES = (
        ("no complete frame yet", with_frames(0)),
        ("no complete frame yet", with_frames(-3)),
        ("VTKHDF/Steps: attribute NSteps is not a whole number", with_frames("three")),
        ("VTKHDF/Steps: attribute NSteps is not a whole number", with_frames(3.5)),
        ("VTKHDF/Steps: attribute NSteps is not a whole number", with_frames(np.array([3, 3]))),
        ("fewer times than frames", with_frames(2**62)),
        ("not results of weavefront: no VTKHDF", without("VTKHDF")),
        ("no VTKHDF/Points", without(POINTS)),
        ("no VTKHDF/Steps", without("VTKHDF/Steps")),
        ("no VTKHDF/Steps/Values", without(TIMES)),
        ("no VTKHDF/Steps/PointOffsets", without("VTKHDF/Steps/PointOffsets")),
        ("no VTKHDF/Steps/PointDataOffsets/displacement", without("VTKHDF/Steps/PointDataOffsets")),
        ("no VTKHDF/Steps/CellDataOffsets/stress_fill", without("VTKHDF/Steps/CellDataOffsets/stress_fill")),
        ("no VTKHDF/CellData/ply", without("VTKHDF/CellData/ply")),
        ("no VTKHDF/Connectivity", without("VTKHDF/Connectivity")),
        (
            "VTKHDF/Connectivity names points that part 0 has not got",
            with_value("VTKHDF/Connectivity", 5, 10**6),
        ),
        (
            "VTKHDF/Connectivity names points that part 0 has not got",
            with_value("VTKHDF/Connectivity", 5, -1),
        ),
        ("cells that are neither quads nor triangles", with_value("VTKHDF/Offsets", 5, 7)),
        ("VTKHDF/NumberOfPoints is [-1, 192]", with_value("VTKHDF/NumberOfPoints", 0, -1)),
        (
            "VTKHDF/PointData/displacement ends before",
            with_value("VTKHDF/Steps/PointDataOffsets/displacement", 1, 2**40),
        ),
        (
            "VTKHDF/Points holds values that are not finite or beyond 1e+06",
            with_value(POINTS, (3, 1), np.nan),
        ),
        ("VTKHDF/Points holds values that are not finite or beyond 1e+06", with_value(POINTS, (3, 1), 1e308)),
        ("displacement holds values that are not finite", with_value(MOVED, (3, 1), -np.inf)),
        ("VTKHDF/Steps/Values holds values that are not finite", with_value(TIMES, 1, np.nan)),
        ("VTKHDF/Steps/Values does not ascend", with_value(TIMES, 1, 0.0)),
        (
            "stress_fill holds values that are not finite",
            with_value("VTKHDF/CellData/stress_fill", slice(None), np.nan),
        ),
        ("VTKHDF/Connectivity asks for 1099511627776 bytes", with_absurd_connectivity),
        (
            "VTKHDF/Points is of shape (3,) and type int64, expected rows of 3 numbers",
            with_array(POINTS, data=[1, 2, 3]),
        ),
        ("expected rows of 3 numbers", with_array(POINTS, shape=(600, 3), dtype="c16")),
        ("scene is not text", with_array("scene", shape=(2**50,), dtype="u1", chunks=(1024,))),
    )

    def test_gives_one_message_and_status_2(self):
        damaged = self.folder / "damaged"
        for part, change in self.CASES:
            with self.subTest(part=part):
                shutil.rmtree(damaged, ignore_errors=True)
                shutil.copytree(self.run_folder, damaged)
                with h5py.File(damaged / "results.vtkhdf", "r+") as file:
                    change(file)
                self.refused(2, part, damaged, "--only", "deformed", naming=damaged / "results.vtkhdf")

    def test_that_cannot_be_opened_gives_status_3(self):
        whole = (self.run_folder / "results.vtkhdf").read_bytes()
        for name, data in (("text", b"no HDF5"), ("empty", b""), ("cut", whole[: len(whole) // 2])):
            with self.subTest(name=name):
                (self.folder / name).mkdir()
                (self.folder / name / "results.vtkhdf").write_bytes(data)
                self.refused(
                    3, "results.vtkhdf: not a readable HDF5 file", self.folder / name, "--only", "deformed"
                )


class DamagedTables(OnRun):
    def history(self, change):
        """A run whose history.csv is changed, as a list of lines."""
        run = self.folder / "table"
        run.mkdir(exist_ok=True)
        lines = (self.run_folder / "history.csv").read_text(encoding="utf-8").splitlines()
        change(lines)
        (run / "history.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
        return run

    def with_field(self, line, name, text):
        """A run with another text in one field."""

        def change(lines):
            fields = lines[line - 1].split(",")
            fields[lines[0].split(",").index(name)] = text
            lines[line - 1] = ",".join(fields)

        return self.history(change)

    def test_values_that_cannot_be_drawn_are_named_with_their_line(self):
        for value in ("nan", "inf", "-inf", "1e308"):
            with self.subTest(value=value):
                run = self.with_field(7, "projectile_vz", value)
                self.refused(
                    2,
                    f"history.csv:7: projectile_vz: {value} is not finite or beyond 1e+100",
                    run,
                    "--only",
                    "history",
                )
        self.refused(
            2,
            "history.csv:7: time: 'soon' is not a number",
            self.with_field(7, "time", "soon"),
            "--only",
            "history",
        )
        self.refused(
            2, "history.csv: the times do not ascend", self.with_field(7, "time", "1"), "--only", "history"
        )
        self.refused(
            2,
            "history.csv:7: field larger than",
            self.with_field(7, "time", "1" * 200000),
            "--only",
            "history",
        )

    def test_shapes(self):
        run = self.history(lambda lines: lines.__setitem__(6, "1,2,3"))
        self.refused(2, "history.csv:7: '1,2,3' has 3 values, the header 25", run, "--only", "history")
        self.refused(
            2,
            "no rows below the header",
            self.history(lambda lines: lines.__delitem__(slice(1, None))),
            "--only",
            "history",
        )
        run = self.history(lambda lines: lines.__setitem__(0, lines[0].replace("hourglass", "time")))
        self.refused(2, "two columns 'time'", run, "--only", "energies")
        run = self.history(lambda lines: lines.__setitem__(0, "time,velocity"))
        self.refused(2, "no column 'projectile_z'; it has time, velocity", run, "--only", "history")

    def test_other_tables(self):
        table = self.folder / "table.csv"
        table.write_text("time,velocity\n0,fast\n", encoding="utf-8")
        self.refused(2, "table.csv:2: velocity: 'fast' is not a number", self.run_folder, "--measured", table)
        table.write_text("time,pressure\n0,1\n", encoding="utf-8")
        self.refused(
            2, "neither a column 'displacement' nor 'velocity'", self.run_folder, "--measured", table
        )
        table.write_bytes(b"time,velocity\n0,\xff\n")
        self.refused(2, "not a text file (UTF-8)", self.run_folder, "--measured", table)
        table.write_text(YARN.format(failure=21), encoding="utf-8")
        self.refused(2, "failure 21 is none of", "--yarn", table, "--output", self.folder / "y.png")
        self.assertFalse((self.folder / "y.png").exists())


class DamagedStudies(OnFolder):
    def study(self, change):
        """A study whose document is changed."""
        document = json.loads(STUDY.read_text(encoding="utf-8"))
        change(document)
        (self.folder / "study.json").write_text(json.dumps(document), encoding="utf-8")

    CASES = (
        ("study.json: document: no 'variants'", lambda d: d.pop("variants")),
        ("study.json: variants: found [], allowed at least one", lambda d: d.update(variants=[])),
        (
            'variants[1].wall_seconds: found "long", allowed a number',
            lambda d: d["variants"][1].update(wall_seconds="long"),
        ),
        (
            "variants[1].wall_seconds: found NaN, allowed a number",
            lambda d: d["variants"][1].update(wall_seconds=float("nan")),
        ),
        (
            "variants[0].errors.strip_strain: found Infinity",
            lambda d: d["variants"][0]["errors"].update(strip_strain=float("inf")),
        ),
        ("variants[0].labels: found [], allowed a list of 1", lambda d: d["variants"][0].update(labels=[])),
        (
            'series[0].variants[0]: found "gone", allowed the name of a',
            lambda d: d["quantities"][0]["series"][0].update(variants=["gone"]),
        ),
        (
            "quantities[0].pareto.element_steps: found [], allowed a list of 4",
            lambda d: d["quantities"][0]["pareto"].update(element_steps=[]),
        ),
        ("study.json: title: found 5, allowed text", lambda d: d.update(title=5)),
        ("no variant has an error to draw", lambda d: [v.update(outcome="stopped") for v in d["variants"]]),
        (
            "60 quantities of 1 series do not fit into one picture",
            lambda d: d.update(quantities=[d["quantities"][0]] * 60),
        ),
    )

    def test_name_what_is_wrong(self):
        for part, change in self.CASES:
            with self.subTest(part=part):
                self.study(change)
                self.refused(2, part, "--study", self.folder)

    def test_that_are_no_json(self):
        for text, part in (
            ("{\n  no JSON", "study.json:2:3: not JSON"),
            ("[" * 200000, "study.json: not JSON of a study"),
            ("[]", "allowed a map"),
        ):
            (self.folder / "study.json").write_text(text, encoding="utf-8")
            self.refused(2, part, "--study", self.folder)


if __name__ == "__main__":
    unittest.main()
