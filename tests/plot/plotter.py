"""What the tests of weavefront-plot share: the program (first argument of each test), small runs, and what a
call must do."""
import html
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PLOT = Path(sys.argv.pop(1)).resolve()
PACKAGES = [str(package) for package in (PLOT.parent, PLOT.parent.parent / "share" / "weavefront" / "plot")]
sys.path[:0] = PACKAGES
sys.dont_write_bytecode = True

ENVIRONMENT = {
    name: value
    for name, value in os.environ.items()
    if name not in ("HDF5_USE_FILE_LOCKING", "PYTHONUNBUFFERED")
}


def plot(*arguments, **keywords):
    """Runs the program."""
    keywords = {"stdout": subprocess.PIPE, "env": ENVIRONMENT, **keywords}
    return subprocess.run(
        [PLOT, *map(str, arguments)], stderr=subprocess.PIPE, text=True, check=False, **keywords
    )


class OnFolder(unittest.TestCase):
    """A folder for the tests of one class."""

    @classmethod
    def setUpClass(cls):
        cls.keep = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.keep.name)

    @classmethod
    def tearDownClass(cls):
        cls.keep.cleanup()

    def drawn(self, *arguments):
        """The names of the files that a successful call leaves in an empty folder."""
        with tempfile.TemporaryDirectory(dir=self.folder) as output:
            result = plot(*arguments, "--output", output)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            for path in Path(output).iterdir():
                self.assertGreater(path.stat().st_size, 100)
            return sorted(path.name for path in Path(output).iterdir())

    def text_of(self, run, picture, *arguments):
        """What is written in a picture of a run, a line for each text."""
        with tempfile.TemporaryDirectory(dir=self.folder) as output:
            result = plot(
                run, "--only", picture.split("_")[0], "--format", "svg", "--output", output, *arguments
            )
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            text = (Path(output) / f"{picture}.svg").read_text(encoding="utf-8")
            return html.unescape("\n".join(re.findall(r"<text [^>]*>([^<]*)</text>", text)))

    def refused(self, status, part, *arguments, naming="", **keywords):
        """The call ends with this status and one line that begins with the file `naming` and holds `part`."""
        result = plot(*arguments, **keywords)
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertTrue(result.stderr.startswith(f"weavefront-plot: error: {naming}"), result.stderr)
        self.assertIn(part, result.stderr)
        self.assertNotIn("cannot be drawn", result.stderr)  # the last resort, which names no cause
