"""A rank that runs out of memory says so and ends all ranks instead of leaving them waiting: out_of_memory.py
WEAVEFRONT MPIEXEC SCENE

Started by mpiexec as out_of_memory.py COMMAND..., it is the command with little memory on the second rank."""

import os
import resource
import subprocess
import sys
import tempfile

LITTLE = (
    400 << 20
)  # bytes of address space: enough to start the program, not for the elements of half of the target


def main(program, mpiexec, scene):
    with tempfile.TemporaryDirectory() as folder:
        run = [program, "run", scene, "--output", folder, "--set", "target.mesh={center: 2 mm}"]
        done = subprocess.run(
            [mpiexec, "-n", "2", sys.executable, "-B", __file__, *run],
            capture_output=True,
            text=True,
            timeout=120,
        )
    print(done.stdout, done.stderr)
    assert done.returncode != 0
    assert "weavefront: error: rank 1: out of memory" in done.stderr


RANK = os.environ.get("OMPI_COMM_WORLD_RANK", os.environ.get("PMI_RANK"))  # of Open MPI or of MPICH
if RANK is not None:
    if RANK == "1":
        resource.setrlimit(resource.RLIMIT_AS, (LITTLE, LITTLE))
    os.execv(sys.argv[1], sys.argv[1:])
main(*sys.argv[1:])
