"""Options of 'weavefront v50' that are refused before anything runs: options.py WEAVEFRONT MPIEXEC"""

import sys
import tempfile
import unittest

from v50_runs import Limits

WEAVEFRONT, MPIEXEC = sys.argv.pop(1), sys.argv.pop(1)

BALL = "{shape: sphere, diameter: 6 mm, mass: 0.3 g, velocity: [0, 0, 200 m/s]}"
REFUSED = (
    (("--from", "200"), "--from: found"),
    (("--from", "200 mm"), "--from: found"),
    (("--from", "0 m/s"), "--from: found '0 m/s', allowed a velocity above 0"),
    (
        ("--from", "300 m/s", "--to", "200 m/s"),
        "--to: found '200 m/s', allowed a velocity above that of --from",
    ),
    (("--width", "0.01 m/s"), "--width: found '0.01 m/s', allowed at least 0.1 m/s"),
    (
        ("--complete", "through"),
        "--complete: found 'through', allowed 'perforated', 'any-ply' or 'witness SPEED'",
    ),
    (("--complete", "witness 3 mm"), "--complete: found 'witness 3 mm'"),
    (("--stiffness", "0.5,x"), "--stiffness: found 'x', allowed factors above 0"),
    (("--mesh", "2 mm,,1 mm"), "target.mesh.center"),
    (("--mesh", "2 kg"), "target.mesh.center"),
    (("--scatter", "projectile.mass"), "--scatter: found 'projectile.mass', allowed PATH=normal"),
    (("--scatter", "projectile.mas=normal(2 g, 1 g)"), "projectile.mas"),
    (("--scatter", "projectile.mass=normal(0.3 g, 0.3 g)", "--count", "100"), "projectile.mass"),
    (("--count", "5"), "--count: found without scatter, allowed with it only"),
    (("--sigma", "5 m/s"), "--sigma: found without scatter, allowed with it only"),
    (
        ("--scatter", "damping=uniform(1 1/s, 2 1/s)", "--width", "2 m/s"),
        "--width: found with scatter, allowed without it only",
    ),
    (
        ("--scatter", "damping=uniform(1 1/s, 2 1/s)", "--count", "0"),
        "--count: found 0, allowed 1 to 10000 shots",
    ),
    (("--confidence", "95"), "--confidence: found 95, allowed a number between 0 and 1"),
    (("--ranks-per-shot", "0"), "--ranks-per-shot: found 0, allowed at least 1"),
    (("--restart", "checkpoint.h5"), "--restart: found 'checkpoint.h5', allowed 'auto'"),
    (("--restart", "auto"), "holds no v50 that could go on"),
    (("--set", "projectile.velocity=[0, 0, 0]"), "projectile.velocity.2: found '0'"),
    (("--set", "fabrics.a.failure="), "found no fabric with failure"),
    (
        ("--set", "projectile=", "--set", f"projectiles=[{BALL}, {BALL}]"),
        "found 2 projectiles, allowed one: a limit is that of one projectile",
    ),
    (("--shots", "nowhere.csv"), "nowhere.csv"),
    (
        ("--scatter", "damping=uniform(1 1/s, 2 1/s)", "--seed", "1000000001"),
        "--seed: found 1000000001, allowed 0 to",
    ),
    (
        ("--set", "fabrics.a.failure.scatter={weibull_modulus: 20, gauge_length: 50 mm}", "--mesh", "2 mm"),
        "--mesh: found with scatter, allowed without it only",
    ),
    (("--wide", "5 m/s"), "option '--wide': unknown"),
)

TABLES = (
    ("", ":1:1: found nothing, allowed a header and shots"),
    ("speed\n", ":1:1: found no column result"),
    ("velocity,result\n", ":1:1: found no column of speeds"),
    ("speed_m_s,result\n300,complete\n,partial\n", ":3:1: speed_m_s: found '', allowed a number above 0"),
    ("result,speed\ncomplete,300\n", ":2:10: speed: found"),
    ("speed_ft_s,result\n900,through\n", ":2:5: result: found 'through', allowed complete or partial"),
    ("speed_ft_s,result\n900\n", ":2:1: found 1 cells, allowed 2"),
    ("speed_m_s,result\n300,none\n", ":1:1: found no shot with a result"),
)


class Refusals(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.limits = Limits(WEAVEFRONT, MPIEXEC, self.scratch.name)

    def refused(self, options, part, ranks=1):
        text = self.limits.v50("out", *options, status=2, ranks=ranks)
        self.assertIn(part, text)
        self.assertFalse((self.limits.folder / "out").exists(), text)

    def test_a_wrong_option_leaves_nothing_behind(self):
        for options, part in REFUSED:
            with self.subTest(options=options):
                self.refused(options, part)

    def test_a_wrong_table_is_refused_with_its_place(self):
        table = self.limits.folder / "range.csv"
        for text, part in TABLES:
            with self.subTest(text=text):
                table.write_text(text)
                self.refused(("--shots", table), f"{table}{part}")

    def test_all_findings_of_the_options_are_told_at_once(self):
        text = self.limits.v50("out", "--from", "1", "--width", "2", "--confidence", "3", status=2)
        for option in ("--from", "--width", "--confidence"):
            self.assertIn(f"error: {option}: found", text)

    def test_several_ranks_tell_it_once(self):
        self.assertEqual(self.limits.v50("out", "--from", "1", status=2, ranks=2).count("--from: found"), 1)


if __name__ == "__main__":
    unittest.main()
