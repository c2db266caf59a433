"""Every frame reads back as it was written, at every rank count, and the files are the same: read_back.py
WRITER MPIEXEC H5DIFF"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py

import model


def write(writer, mpiexec, ranks, path, frames, max_frames, projectile, cut):
    """Runs the writer."""
    command = [
        mpiexec,
        "-n",
        str(ranks),
        writer,
        str(path),
        str(frames),
        str(max_frames),
        str(projectile),
        *cut,
    ]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def check_provenance(path):
    """The scene and the version are inside."""
    with h5py.File(path) as file:
        assert bytes(file["scene"][:]) == b"title: synthetic\n"
        assert file.attrs["version"] == b"1.2.3"


def main():
    writer, mpiexec, h5diff = sys.argv[1:]
    os.environ["HDF5_USE_FILE_LOCKING"] = "FALSE"
    with tempfile.TemporaryDirectory() as folder:
        # More frames than one, none, a run that stopped before its last frame, files that are cut and one
        # that grows.
        for frames, max_frames, projectile, *cut in [
            (4, 4, 1),
            (4, 4, 0),
            (0, 3, 1),
            (1, 3, 1),
            (2, 5, 1),
            (0, 3, 1, "cut"),
            (2, 5, 0, "cut"),
            (9, 2, 1),
        ]:
            files = [
                Path(folder) / f"{frames}-{max_frames}-{projectile}-{ranks}{''.join(cut)}.vtkhdf"
                for ranks in range(1, 5)
            ]
            for ranks, path in enumerate(files, start=1):
                path.write_text("an older file, to be replaced")
                write(writer, mpiexec, ranks, path, frames, max_frames, projectile, cut)
                assert model.check_frames(path, projectile == 1) == frames
                check_provenance(path)
            with h5py.File(files[0]) as file:
                room = len(file["VTKHDF/Steps/PointOffsets"])
            assert room == max(frames, 1) if cut else room >= frames, (frames, room)
            for path in files[1:]:
                subprocess.run([h5diff, str(files[0]), str(path)], check=True)
                # Byte by byte they are written at different times: nothing of the moment is inside.
                assert path.read_bytes() == files[0].read_bytes(), path
        left = {path.suffix for path in Path(folder).iterdir()}
        assert left == {".vtkhdf"}, left


main()
