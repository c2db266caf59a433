"""Runs that a fault ends: small file systems to be filled, and what every such run has to leave."""

import csv
import math
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "command_line"))

from small_run import KILLED, Program, errors_of, is_open_mpi, processes_of  # noqa: E402, F401

SKIPPED = 77
SECONDS = 20  # until all ranks are gone, on a busy machine; alone it takes two
HANGING = 120  # then a run is killed
# Steps for some seconds; rows and frames come as a case asks for them.
LONG = (
    "target.mesh={center: 1 mm, edge: 2 mm}",
    "time.end=20 ms",
    "output.interval=20 ms",
    "output.history=20 ms",
)


# Few steps apart: with more ranks than cores, on a busy machine, a step may take a tenth of a second.
FRAMES = ("time.end=4 ms", "output.interval=20 us", "output.history=4 ms")


def enter_own_mounts():
    """Starts the script anew where it may mount file systems that nobody else sees. No privileges are needed.
    Some systems forbid it."""
    if "WEAVEFRONT_OWN_MOUNTS" in os.environ:
        return
    for options in ("-Urm", "-m"):
        if subprocess.run(["unshare", options, "true"], capture_output=True).returncode == 0:
            os.environ["WEAVEFRONT_OWN_MOUNTS"] = "1"
            os.execvp("unshare", ["unshare", options, sys.executable, "-B", *sys.argv])
    print("skipped: no file system can be mounted, for lack of user namespaces and of the rights of root")
    sys.exit(SKIPPED)


class Disk:
    """A small file system in memory."""

    def __init__(self, path, size="60m"):
        self.path = Path(path)
        self.path.mkdir(exist_ok=True)
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(self.path)], check=True)

    def fill(self, leave=0):
        with open(self.path / "filler", "wb", buffering=0) as file:
            try:
                while True:
                    file.write(bytes(4096))
            except OSError:
                pass
            file.truncate(max(0, file.tell() - leave))

    def free(self):
        (self.path / "filler").unlink()

    def make_read_only(self):
        subprocess.run(["mount", "-o", "remount,ro", str(self.path)], check=True)

    def unmount(self):
        subprocess.run(["umount", "-l", str(self.path)], check=True)


def has_frame(path):
    """Whether the first frame is complete: a fault before then is one of the first frame."""
    try:
        with h5py.File(path, locking=False) as file:
            return int(file["VTKHDF/Steps"].attrs["NSteps"]) > 0
    except OSError:  # not there, or about to change
        return False


def end_by(program, output, overrides=LONG, ranks=1, options=(), fault=None, ready="results.vtkhdf"):
    """Runs until `fault` has ended the run. It is called with the processes of the ranks once the file
    `ready` and the first frame are there.

    Returns the status and the error lines. All ranks must be gone within SECONDS of the message, or of the
    fault where there is none."""
    process = subprocess.Popen(
        program.command(output, overrides, ranks, options),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    pids = []
    end = threading.Timer(HANGING, lambda: [os.kill(pid, signal.SIGKILL) for pid in [*pids, process.pid]])
    end.start()
    if fault:
        folder = program.folder / output
        while not ((folder / ready).exists() and has_frame(folder / "results.vtkhdf")):
            assert process.poll() is None, process.communicate()
            time.sleep(0.005)
        pids += processes_of(process)
        assert len(pids) == ranks, pids
        fault(pids)
    told = time.monotonic()
    text = ""
    for line in process.stderr:
        text += line
        if errors_of(line):
            told = time.monotonic()
    process.wait()
    while any(Path(f"/proc/{pid}/exe").exists() for pid in pids):
        time.sleep(0.01)
        assert time.monotonic() - told < SECONDS, "ranks are left"
    end.cancel()
    seconds = time.monotonic() - told
    errors = errors_of(text)
    print(f"{output}: {ranks} ranks, status {process.returncode}, {seconds:.2f} s, {errors}", flush=True)
    assert seconds < SECONDS, text
    raw = ("HDF5", "mca_", "*** Process received signal")
    assert not any(word in text for word in raw), text
    return process.returncode, errors


def require(ended, status, message):
    """One message, with this text in it."""
    found, errors = ended
    assert found == status and len(errors) == 1 and message in errors[0], ended


def require_readable(folder, logged=None):
    """Rows are whole, frames are finite, and the log ends with the message."""
    rows = list(csv.DictReader((folder / "history.csv").open()))
    assert (folder / "history.csv").read_bytes().endswith(b"\n")
    assert rows and all(math.isfinite(float(value)) for row in rows for value in row.values())
    with h5py.File(folder / "results.vtkhdf", locking=False) as file:
        root = file["VTKHDF"]
        frames = int(root["Steps"].attrs["NSteps"])
        points = frames * int(root["NumberOfPoints"][:].sum())
        assert (
            frames > 0
            and np.isfinite(root["Steps/Values"][:frames]).all()
            and np.isfinite(root["Points"][:points]).all()
        )
    if logged:
        *_, ended, last = (folder / "run.log").read_text().splitlines()
        assert ended.startswith("Ended at t = ") and logged in ended and last.startswith("  ended "), (
            ended,
            last,
        )
    assert not [path.name for path in folder.iterdir() if path.name.endswith((".new", ".lock"))], list(
        folder.iterdir()
    )


def require_restart(program, output, ranks=1, overrides=LONG):
    """The run goes on from its checkpoint; it leaves again after a second."""
    status, errors = end_by(program, output, overrides, ranks, ["--restart", "auto", "--walltime", "1 s"])
    assert status == 4 and len(errors) == 1 and "a checkpoint was written" in errors[0], (status, errors)
    assert "restart" in (program.folder / output / "run.log").read_text()
