"""A scene of a second or less, and runs of it."""

import json
import os
import signal
import subprocess
import time

SCENE = """
title: Small
fabrics:
  a:
    areal_density: 204 g/m^2
    density: 1440 kg/m^3
    yarn: {span: 0.9 mm, area: 0.06 mm^2, width: 0.3 mm}
    thickness: 0.2 mm
    elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa, viscosity: 35 MPa s}
    transverse_shear: 2.5 GPa
target:
  size: [40 mm, 40 mm]
  plies: {count: 2, fabric: a, spacing: 0.25 mm}
  mesh: {center: 2 mm, edge: 4 mm}
  symmetry: [x, y]
projectile: {shape: sphere, diameter: 6 mm, mass: 0.9 g, velocity: [0, 0, 100 m/s]}
contact: {projectile: {}, plies: {}}
time: {end: 5 us}
output: {interval: 1 us, history: 0.5 us}
"""
# Steps for some seconds.
LONG = (
    "target.mesh={center: 0.5 mm, edge: 1 mm}",
    "time.end=2 ms",
    "output.interval=20 us",
    "output.history=5 us",
)
# What a launcher makes of a killed rank (Open MPI 137, MPICH 9), and its own status when it is killed itself.
KILLED = (128 + signal.SIGKILL, signal.SIGKILL, -signal.SIGKILL)
FILES = {"history.csv", "results.vtkhdf", "summary.json", "run.log"}


def sets(overrides):
    return [word for override in overrides for word in ("--set", override)]


class Program:
    """The program, the mpirun that starts it and a folder with the scene."""

    def __init__(self, weavefront, mpiexec, folder):
        self.weavefront, self.mpiexec, self.folder = weavefront, mpiexec, folder
        (folder / "scene.yaml").write_text(SCENE)

    def command(self, output, overrides=(), ranks=1, options=()):
        launcher = [self.mpiexec, "-n", str(ranks)] if ranks > 1 else []
        return [
            *launcher,
            self.weavefront,
            "run",
            str(self.folder / "scene.yaml"),
            "--output",
            str(self.folder / output),
            *sets(overrides),
            *options,
        ]

    def run(self, output, overrides=(), ranks=1, options=(), status=0, **keywords):
        """Runs to the end; AssertionError unless it leaves with `status`. Returns its error lines."""
        done = subprocess.run(
            self.command(output, overrides, ranks, options),
            capture_output=True,
            text=True,
            timeout=100,
            **keywords,
        )
        assert done.returncode == status, (done.args, done.returncode, done.stdout, done.stderr)
        return errors_of(done.stderr)

    def start(self, output, overrides=LONG, ranks=1, options=()):
        """Starts a run and returns when the last of its files has its name."""
        process = subprocess.Popen(
            self.command(output, overrides, ranks, options),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        while not (self.folder / output / "results.vtkhdf").exists():
            assert process.poll() is None, process.communicate()
            time.sleep(0.01)
        return process


def is_open_mpi(mpiexec):
    return "OpenRTE" in subprocess.run([mpiexec, "--version"], capture_output=True, text=True).stdout


def statuses_when_signalled(mpiexec):
    """What mpirun may return when it passes a signal on and the ranks return 4. That of MPICH sometimes loses
    their status."""
    return {4} if is_open_mpi(mpiexec) else {0, 4}


def variable_of_launcher(mpiexec, name, value):
    """Options by which mpirun sets a variable for the ranks of one command."""
    return ["-x", f"{name}={value}"] if is_open_mpi(mpiexec) else ["-env", name, value]


def errors_of(text):
    return [
        line.removeprefix("weavefront: error: ")
        for line in text.splitlines()
        if line.startswith("weavefront: error: ")
    ]


def bytes_of(folder):
    """Contents of a folder's files by name."""
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def summary(folder):
    return json.loads((folder / "summary.json").read_text())


def processes_of(process):
    """Processes of the program that mpirun or nobody has started: those of `process` and its children."""
    found, waiting = [], [process.pid]
    while waiting:
        pid = waiting.pop()
        try:
            with open(f"/proc/{pid}/comm") as file:
                if file.read().strip() == "weavefront":
                    found.append(pid)
            for task in os.listdir(f"/proc/{pid}/task"):
                with open(f"/proc/{pid}/task/{task}/children") as file:
                    waiting += [int(child) for child in file.read().split()]
        except FileNotFoundError:
            pass
    return sorted(found)
