"""Copies that believe to be alone are told so: launch.py WEAVEFRONT SCENE MPIEXEC"""

import os
import subprocess
import sys
import tempfile

# What launchers of other MPIs, or srun without one, set for one of four processes.
OTHERS = (
    {"PMI_SIZE": "4", "PMI_RANK": "0"},
    {"OMPI_COMM_WORLD_SIZE": "4", "OMPI_COMM_WORLD_RANK": "0"},
    {"SLURM_NTASKS": "4", "SLURM_STEP_NUM_TASKS": "4", "SLURM_PROCID": "0"},
)
ALONE = (
    {"PMI_SIZE": "1", "PMI_RANK": "0"},
    {"SLURM_NTASKS": "4", "SLURM_PROCID": "0"},  # in a job script, not started by srun
    {
        "OMPI_COMM_WORLD_SIZE": "1",
        "SLURM_NTASKS": "4",
        "SLURM_STEP_NUM_TASKS": "4",
    },  # mpirun -n 1 inside a job
)


def call(program, variables, *arguments):
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("OMPI_COMM", "PMI", "SLURM"))}
    done = subprocess.run(
        [program, *arguments], capture_output=True, text=True, env=environment | variables, timeout=60
    )
    print(variables, arguments[0], done.returncode, done.stderr)
    return done


def main():
    program, scene, mpiexec = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with open("study.yaml", "w") as file:
            file.write(
                f"scene: {scene}\nvariants:\n  - {{time.end: [1 us]}}\nquantities: [residual_velocity]\n"
            )
        output = ("--output", "out", "--overwrite")
        small = (
            "--set",
            "target.mesh.center=4 mm",
            "--set",
            "target.mesh.edge=4 mm",
            "--set",
            "time.end=1 us",
            "--set",
            "output.interval=0",
            "--set",
            "target.plies.count=1",
        )
        for variables in OTHERS:
            size = next(name for name in variables if name.endswith(("SIZE", "NTASKS")))
            for arguments in (
                ("run", scene, *output, *small),
                ("study", "study.yaml"),
                ("partition", scene, "--ranks", "1"),
            ):
                done = call(program, variables, *arguments)
                assert done.returncode == 2 and done.stderr.count("weavefront: error: ") == 1, done
                assert (
                    f"found one rank where the launcher has started 4 processes ({size}=4)" in done.stderr
                ), done
                other = {
                    name: "2" if name.endswith(("RANK", "PROCID")) else value
                    for name, value in variables.items()
                }
                done = call(program, other, *arguments)
                assert done.returncode == 2 and done.stderr == "", done
            assert call(program, variables, "check", scene).returncode == 0
        assert os.listdir() == ["study.yaml"], os.listdir()
        for variables in ALONE:
            assert call(program, variables, "run", scene, *output, *small).returncode == 0
        assert (
            subprocess.run(
                [mpiexec, "-n", "2", program, "run", scene, *output, *small], timeout=60
            ).returncode
            == 0
        )


main()
