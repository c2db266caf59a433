#!/usr/bin/python3
"""Pictures of a v50, and documents that are none: test_v50.py PATH/TO/weavefront-plot."""
import copy
import json
import math
import re
import unittest

import matplotlib.pyplot as plt

from plotter import OnFolder, plot
from weavefront_plot import style, v50
from weavefront_plot.v50_table import read_v50

FOOT = 0.3048


def shot(speed, result, residual=None, variant="scene"):
    """A row of v50.json; speeds in m/s."""
    return {
        "variant": variant,
        "speed": speed,
        "result": result,
        "residual": residual,
        "absorbed_energy": None if residual is None else 5e-4 * (speed**2 - residual**2),
    }


DOCUMENT = {
    "title": "Plies of $\\foo$",
    "unit": {"name": "ft/s", "si": FOOT},
    "projectile_mass": 1e-3,
    "confidence": 0.95,
    "limits": [{"partial": 298.0, "complete": 302.0}],
    "mixed_results": {"lowest_complete": 302.0, "highest_partial": 310.0},
    "mil_std_662f": {"v50": 303.0},
    "normal": {
        "refused": None,
        "v50": {"value": 304.0},
        "quantiles": [
            {
                "probability": p,
                "value": 304.0 + 10 * (p - 0.5),
                "lower": None if p < 0.5 else 299.0,
                "upper": 312.0,
            }
            for p in (0.05, 0.5, 0.95)
        ],
    },
    "logistic": {"refused": "no fit: why"},
    "recht_ipson": {"v50": 300.0, "a": 1.0, "p": 2.0},
    "lambert_jonas": {"v50": 299.0, "a": 0.9, "p": 2.4},
    "shots": [
        shot(280.0, "partial", -20.0),
        shot(302.0, "complete", 35.0),
        shot(310.0, "partial", -4.0),
        shot(310.0, "partial", variant="range"),
        shot(330.0, "complete", 138.0),
        shot(320.0, "none"),
        shot(700.0, "complete", 600.0, variant="mesh 2 mm"),
    ],
}


class V50(OnFolder):
    def write(self, change=lambda document: None):
        document = copy.deepcopy(DOCUMENT)
        change(document)
        (self.folder / "v50.json").write_text(json.dumps(document), encoding="utf-8")

    def lines_of(self, figure):
        """Points of each line of the picture by the first words of its label."""
        return {
            line.get_label().split(",")[0]: list(zip(*line.get_data())) for line in figure.axes[0].get_lines()
        }

    def figures(self):
        style.apply()
        self.addCleanup(plt.close, "all")
        table = read_v50(self.folder)
        return [f(table) for f in (v50.response_figure, v50.residual_figure, v50.energy_figure)]

    def test_are_drawn_in_the_unit_of_the_results(self):
        self.write()
        response, residual, energy = map(self.lines_of, self.figures())
        left, right = self.figures()[0].axes[0].get_xlim()
        self.assertTrue(280 / FOOT > left > 250 / FOOT and 330 / FOOT < right < 350 / FOOT)  # no other mesh
        self.assertEqual(len(response["computed shots"]), 4)
        self.assertEqual(len(response["shots of the range"]), 1)
        self.assertEqual(response["no result"][0], (320 / FOOT, 0.5))
        self.assertEqual(response["normal"][1], (304 / FOOT, 0.5))
        self.assertNotIn("logistic", response)
        self.assertEqual(
            residual["complete penetrations"], [(302 / FOOT, 35 / FOOT), (330 / FOOT, 138 / FOOT)]
        )
        self.assertEqual(residual["partial penetrations"], [(280 / FOOT, 0), (310 / FOOT, 0)])
        speed, value = residual["Recht-Ipson"][-1]
        self.assertAlmostEqual(value * FOOT, math.sqrt((speed * FOOT) ** 2 - 300**2), places=6)
        speed, value = energy["striking energy"][0]
        self.assertAlmostEqual(value, 5e-4 * (speed * FOOT) ** 2)

    def test_shots_at_one_place_lie_over_each_other(self):
        self.write()
        heights = [y for _, y in self.lines_of(self.figures()[0])["computed shots"]]
        heights += [y for _, y in self.lines_of(self.figures()[0])["shots of the range"]]
        self.assertEqual(len([y for y in heights if y == 0]), 2)
        self.assertEqual(len([y for y in heights if y > 0 and y < 0.1]), 1)

    def test_are_drawn_without_a_fit_and_without_curves(self):
        self.write(
            lambda d: d.update(
                normal={"refused": "no fit"},
                recht_ipson=None,
                lambert_jonas=None,
                mil_std_662f=None,
                mixed_results=None,
            )
        )
        done = plot("--v50", self.folder, "--format", "svg")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        text = (self.folder / "plots/response.svg").read_text(encoding="utf-8")
        self.assertEqual(len(re.findall(r"bracket, 977\.7 to 990\.8 ft/s", text)), 1)
        self.assertIn("Plies of $\\foo$", text)

    def test_into_another_folder(self):
        self.write()
        done = plot("--v50", self.folder, "--output", self.folder / "elsewhere")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        names = sorted(path.name for path in (self.folder / "elsewhere").iterdir())
        self.assertEqual(names, ["energy.png", "residual.png", "response.png"])

    CASES = (
        ("v50.json: document: no 'shots'", lambda d: d.pop("shots")),
        ("shots: found [], allowed at least one shot", lambda d: d.update(shots=[])),
        (
            'shots[0].result: found "maybe", allowed complete, partial, none',
            lambda d: d["shots"][0].update(result="maybe"),
        ),
        ("shots[1].speed: found NaN, allowed a number", lambda d: d["shots"][1].update(speed=float("nan"))),
        ("limits: found [], allowed at least one", lambda d: d.update(limits=[])),
        ("si: found 0.0, allowed a number above 0", lambda d: d["unit"].update(si=0.0)),
        ("recht_ipson.p: found 0, allowed a number above 0", lambda d: d["recht_ipson"].update(p=0)),
        ("v50: found -1, allowed a number of at least 0", lambda d: d["recht_ipson"].update(v50=-1)),
    )

    def test_documents_that_are_none_are_named(self):
        for part, change in self.CASES:
            with self.subTest(part=part):
                self.write(change)
                self.refused(2, part, "--v50", self.folder)

    def test_the_option_goes_with_no_other_source(self):
        self.refused(2, "give one of RUN, --yarn, --study and --v50", "RUN", "--v50", "DIR")
        self.refused(2, "--field does not go with --v50", "--v50", "DIR", "--field", "height")
        self.refused(3, "v50.json: No such file", "--v50", self.folder / "nowhere")


if __name__ == "__main__":
    unittest.main()
