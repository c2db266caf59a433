#!/usr/bin/python3
"""Labels of pictures: none over another, and the words of a file as they stand: test_labels.py
PATH/TO/weavefront-plot."""
import json
import unittest
from itertools import combinations
from pathlib import Path

import h5py
import matplotlib.image
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.text import Text

from plotter import OnFolder, plot
from synthetic_run import write_run
from weavefront_plot import section, style, study
from weavefront_plot.study import series_label
from weavefront_plot.study_table import Axis, Series, Study, read_study

STUDIES = Path(__file__).resolve().parents[2] / "examples" / "studies"


def overlaps(figure):
    """Pairs of texts whose boxes share more than a hair."""
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    texts = [text for text in figure.findobj(Text) if text.get_visible() and text.get_text().strip()]
    shown = [text for text in texts if not hidden(text, figure)]
    boxes = [text.get_window_extent(renderer).padded(-0.5) for text in shown]
    return [
        (a.get_text(), b.get_text())
        for (a, box), (b, other) in combinations(zip(shown, boxes), 2)
        if a is not b and box.overlaps(other)
    ]


def hidden(text, figure):
    """Whether it is the label of a tick outside its axis."""
    for axes in figure.axes:
        for axis, index in ((axes.xaxis, 0), (axes.yaxis, 1)):
            low, high = sorted(axis.get_view_interval())
            for tick in [*axis.get_major_ticks(), *axis.get_minor_ticks()]:
                if text in (tick.label1, tick.label2):
                    return (
                        not low * (1 - 1e-9) - 1e-300 <= text.get_position()[index] <= high * (1 + 1e-9)
                        or not axes.axison
                    )
    return False


class Overlaps(OnFolder):
    def setUp(self):
        style.apply()
        self.addCleanup(plt.close, "all")

    def figure_of(self, folder):
        """The picture of a study."""
        table = read_study(folder)
        return study.figure_of(
            table, [quantity for quantity in table.quantities if study.errors_of(table, quantity.name)]
        )

    def test_of_the_shipped_studies(self):
        for name in ("impact_mesh", "cell", "waves", "yarn_law"):
            with self.subTest(study=name):
                self.assertEqual(overlaps(self.figure_of(STUDIES / name)), [])

    def test_of_a_study_with_many_series_and_long_names(self):
        document = json.loads((STUDIES / "impact_mesh" / "study.json").read_text(encoding="utf-8"))
        document["axes"][2]["name"] = "contact.projectile.an_uncommonly_long_name_of_a_value"
        for quantity in document["quantities"]:
            quantity["series"] *= 4
            name = quantity["name"] + "_of_the_last_ply_in_the_last_frame"
            for row in document["variants"]:
                row["errors"][name] = row["errors"].pop(quantity["name"])
            quantity["name"] = name
        (self.folder / "study.json").write_text(json.dumps(document), encoding="utf-8")
        self.assertEqual(overlaps(self.figure_of(self.folder)), [])

    def test_of_ticks_that_lie_close_together_differ(self):
        figure, axes = plt.subplots()
        axes.set(xscale="log", xlim=(9.0e5, 9.4e5))
        axes.yaxis.set_ticks([])
        study.scale(axes.xaxis, 9.0e5, 9.4e5)
        figure.canvas.draw()
        low, high = axes.get_xlim()
        shown = [
            tick.label1.get_text() for tick in axes.xaxis.get_major_ticks() if low <= tick.get_loc() <= high
        ]
        self.assertGreater(len(shown), 1)
        self.assertEqual(len(shown), len(set(shown)), shown)
        self.assertFalse(overlaps(figure))
        plt.close(figure)

    def test_of_the_key_of_any_number_of_plies(self):
        for count in (2, 8, 30, 400):
            for heights in ([9.0], [12.0, 20.0, 25.0]):
                with self.subTest(plies=count, strips=len(heights)):
                    figure, panels = section.panels_of(heights, 60.0)
                    for panel in panels:
                        panel.set_axis_off()
                    section.draw_key(figure, panels, np.arange(1, count + 1))
                    self.assertEqual(overlaps(figure), [])
                    self.assertGreaterEqual(
                        figure.axes[-1].get_position().y0, -1e-9
                    )  # no lower than the strips


class Studies(unittest.TestCase):
    def test_bare_numbers_in_the_legend_say_of_what(self):
        axes = [Axis(name, {}) for name in ("a.formulation", "cell.refinement", "projectile.velocity.2", "h")]
        table = Study("", axes, "h", [], [])
        label = series_label(table, Series(["paper", "10", "5 %"], [], 1.0))
        self.assertEqual(label.replace("\u2009", " "), "paper, refinement 10, velocity.2 5 %: order 1.0")

    def test_error_is_drawn_over_element_size_where_the_study_varies_it(self):
        sizes = {name: study.sizes_of(read_study(STUDIES / name)) for name in ("waves", "cell")}
        self.assertEqual(sizes["cell"], {})
        self.assertEqual(
            sizes["waves"],
            {"center=1mm": 1.0, "center=0.5mm": 0.5, "center=0.25mm": 0.25, "center=0.125mm": 0.125},
        )


class Literal(OnFolder):
    TITLES = ("$\\foo$", "$x^$", "costs $5, or $6", "100 % \\alpha {} %s", '"Plies" & <yarns>', "a\\$b")

    def titled(self, title):
        """A run of this title, as weavefront writes it."""
        run = self.folder / "titled"
        write_run(run, count=4, plies=1, frames=2)
        escaped = title.replace("\\", "\\\\").replace('"', '\\"')
        with h5py.File(run / "results.vtkhdf", "r+") as file:
            del file["scene"]
            file["scene"] = np.frombuffer(f'title: "{escaped}"\ntarget:\n  symmetry: [x, y]\n'.encode(), "u1")
        return run

    def test_titles_are_drawn_as_they_stand(self):
        for title in self.TITLES:
            for picture in ("history", "energies"):
                with self.subTest(title=title, picture=picture):
                    self.assertIn(title, self.text_of(self.titled(title), picture).splitlines())

    def test_long_titles_are_cut(self):
        run = self.titled("x" * 3000)
        self.assertEqual(plot(run, "--only", "history,energies").stderr, "")
        for picture in ("history", "energies"):
            self.assertLess(matplotlib.image.imread(run / "plots" / f"{picture}.png").shape[1], 2200)

    def test_arrays_are_named_as_they_stand(self):
        run = self.titled("x")
        with h5py.File(run / "results.vtkhdf", "r+") as file:
            file["VTKHDF/CellData/$\\foo$"] = np.ones(file["VTKHDF/NumberOfCells"][:].sum())
        self.assertIn(
            "$\\foo$",
            self.text_of(run, "deformed_200us", "--times", "200us", "--field", "$\\foo$").splitlines(),
        )

    def test_words_of_a_study_are_drawn_as_they_stand(self):
        text = (STUDIES / "waves" / "study.json").read_text(encoding="utf-8")
        words = json.dumps("$\\foo$")[1:-1]
        text = text.replace("strip_strain", words).replace("Waves in", words)
        (self.folder / "study.json").write_text(text, encoding="utf-8")
        self.assertEqual(plot("--study", self.folder, "--format", "svg").stderr, "")
        self.assertEqual((self.folder / "study.svg").read_text(encoding="utf-8").count("$\\foo$"), 2)


if __name__ == "__main__":
    unittest.main()
