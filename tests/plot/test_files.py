#!/usr/bin/python3
"""How weavefront-plot writes its files: test_files.py PATH/TO/weavefront-plot."""
import os
import resource
import unittest

from plotter import ENVIRONMENT, OnFolder, plot
from synthetic_run import write_run


class Files(OnFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.run_folder = cls.folder / "run"
        write_run(cls.run_folder, count=4, plies=2, frames=3)

    def setUp(self):
        self.output = self.folder / self.id().rsplit(".", 1)[1]
        self.output.mkdir()
        self.picture = self.output / "history.png"
        self.call = (self.run_folder, "--only", "history", "--output", self.output)

    def test_a_picture_is_replaced(self):
        self.picture.write_text("earlier", encoding="utf-8")
        self.assertEqual(plot(*self.call).returncode, 0)
        self.assertEqual(self.picture.read_bytes()[:4], b"\x89PNG")
        self.assertEqual(os.listdir(self.output), ["history.png"])

    def test_a_link_is_not_replaced_nor_followed(self):
        target = self.output / "target"
        target.write_text("of somebody else", encoding="utf-8")
        self.picture.symlink_to(target)
        self.refused(3, "history.png: is a link", *self.call)
        self.assertTrue(self.picture.is_symlink())
        self.assertEqual(target.read_text(encoding="utf-8"), "of somebody else")

    def test_what_is_no_file_is_not_replaced(self):
        os.mkfifo(self.picture)
        self.refused(3, "history.png: is a device or a pipe", *self.call)
        self.assertTrue(self.picture.is_fifo())
        (self.output / "energies.png").mkdir()
        self.refused(
            3, "energies.png: is a folder", self.run_folder, "--only", "energies", "--output", self.output
        )
        self.refused(
            3, "history.csv: File exists", self.run_folder, "--output", self.run_folder / "history.csv"
        )

    def test_a_full_disk_leaves_what_was_there(self):
        def no_more_than(size):
            return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

        for picture, name, more in (
            ("history", "history.png", ()),
            ("deformed", "deformed.gif", ("--animate", "gif")),
            ("contour", "contour_100us.pdf", ("--format", "pdf")),
        ):
            with self.subTest(picture=picture):
                (self.output / name).write_text("earlier", encoding="utf-8")
                call = (self.run_folder, "--only", picture, *more, "--output", self.output)
                self.refused(3, f"{name}: File too large", *call, preexec_fn=no_more_than(1000))
                self.assertEqual((self.output / name).read_text(encoding="utf-8"), "earlier")
                self.assertEqual([left for left in os.listdir(self.output) if left.startswith(".")], [])

    def test_nobody_need_read_the_list_of_pictures(self):
        reading, writing = os.pipe()
        os.close(reading)
        done = plot(self.run_folder, "--only", "history,energies", "--output", self.output, stdout=writing)
        os.close(writing)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(sorted(os.listdir(self.output)), ["energies.png", "history.png"])

    def test_a_list_that_cannot_be_written_is_an_error(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = plot(*self.call, stdout=full)
        self.assertEqual(
            (done.returncode, done.stderr),
            (3, "weavefront-plot: error: standard output: No space left on device\n"),
        )

    def test_names_of_folders_may_be_any_bytes(self):
        name = os.fsdecode(os.fsencode(self.output) + b"/\xe4\n$x$")
        self.assertEqual(plot(self.run_folder, "--only", "history", "--output", name).stderr, "")
        self.assertEqual(os.listdir(name), ["history.png"])

    def test_settings_of_the_user_do_not_count(self):
        (self.output / "matplotlibrc").write_text("text.usetex: True\nfigure.dpi: 1\n", encoding="utf-8")
        done = plot(*self.call, cwd=self.output, env={**ENVIRONMENT, "MPLBACKEND": "nonsense"})
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
