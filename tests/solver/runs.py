"""Runs of the program and what they leave."""

import csv
import json
import subprocess


class Program:
    """The program and the mpirun that starts it."""

    def __init__(self, weavefront, mpiexec=None):
        self.weavefront, self.mpiexec = weavefront, mpiexec

    def run(self, scene, output, overrides=(), ranks=1, status=0, options=()):
        """Computes a scene into a folder, in place of a run that is there; AssertionError unless it leaves
        with `status`. Returns what it wrote to standard error."""
        command = [self.mpiexec, "-n", str(ranks)] if ranks > 1 else []
        command += [self.weavefront, "run", str(scene), "--output", str(output), "--overwrite", *options]
        for override in overrides:
            command += ["--set", override]
        done = subprocess.run(command, capture_output=True, text=True)
        assert (
            done.returncode == status
        ), f"{' '.join(command)}: status {done.returncode}, expected {status}\n{done.stdout}{done.stderr}"
        return done.stderr


def history(output):
    """Rows of history.csv as dictionaries of numbers."""
    with open(output / "history.csv", newline="") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def history_bytes(output):
    return (output / "history.csv").read_bytes()


def summary(output):
    return json.loads((output / "summary.json").read_text())
