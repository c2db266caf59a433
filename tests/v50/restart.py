"""A v50 that was killed goes on where it was, with the same table: restart.py WEAVEFRONT MPIEXEC"""

import json
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from v50_runs import Limits

WEAVEFRONT, MPIEXEC = sys.argv.pop(1), sys.argv.pop(1)
# Shots of about a second.
SLOWER = ("--set", "target.mesh={center: 0.5 mm, edge: 1 mm}", "--checkpoint-every", "200 steps")
ENDS = ("--from", "100 m/s", "--to", "220 m/s", "--width", "30 m/s", *SLOWER)


class Restart(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.limits = Limits(WEAVEFRONT, MPIEXEC, self.scratch.name)
        self.folder = self.limits.folder

    def start(self, output, ranks=1):
        """Returns the process when it is in the middle of its second shot, and that shot's folder."""
        process = subprocess.Popen(
            self.limits.command(output, *ENDS, ranks=ranks),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        while True:
            self.assertIsNone(process.poll())
            found = sorted((self.folder / output).glob("shot_002_*/checkpoint.h5"))
            if found:
                return process, found[0].parent
            time.sleep(0.005)

    def test_a_killed_v50_goes_on_from_the_checkpoint_of_its_shot(self):
        self.limits.v50("whole", *ENDS)
        process, second = self.start("killed")
        process.kill()
        process.wait()
        self.assertFalse((second / "summary.json").exists())
        first = next((self.folder / "killed").glob("shot_001_*"))
        finished_at = (first / "summary.json").stat().st_mtime_ns
        self.limits.v50("killed", *ENDS, "--restart", "auto", ranks=2)
        self.assertEqual((first / "summary.json").stat().st_mtime_ns, finished_at)
        self.assertIn("  restart       from ", (second / "run.log").read_text())
        for name in ("v50.csv", "v50.json"):
            whole, killed = ((self.folder / output / name).read_bytes() for output in ("whole", "killed"))
            self.assertEqual(whole, killed, name)
        # Once more: everything is there.
        before = (second / "summary.json").stat().st_mtime_ns
        self.limits.v50("killed", *ENDS, "--restart", "auto")
        self.assertEqual((second / "summary.json").stat().st_mtime_ns, before)

    def test_a_signal_leaves_a_checkpoint_and_status_4(self):
        process, second = self.start("asked")
        process.send_signal(signal.SIGUSR1)
        text = "".join(process.communicate(timeout=60))
        self.assertEqual(process.returncode, 4, text)
        self.assertIn("--restart auto", text)
        self.assertEqual(json.loads((second / "summary.json").read_text())["status"], "interrupted")
        self.assertEqual([row["outcome"] for row in self.limits.rows("asked")][1], "interrupted")
        self.limits.v50("asked", *ENDS, "--restart", "auto")
        self.assertNotIn("interrupted", (self.folder / "asked/v50.csv").read_text())

    def test_shots_of_another_scene_are_not_gone_on_with(self):
        process, _ = self.start("other")
        process.kill()
        process.wait()
        text = self.limits.v50(
            "other", *ENDS, "--restart", "auto", "--set", "projectile.mass=0.2 g", status=2
        )
        self.assertIn("of another scene or other options", text)


if __name__ == "__main__":
    unittest.main()
