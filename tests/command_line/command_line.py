"""What the program says and returns for a command line, before any scene is computed: command_line.py
WEAVEFRONT MPIEXEC"""

import os
import subprocess
import sys
import tempfile

BAD_SCENE = "titel: x\nfabrics: {a: 3}\n"

# arguments, exit status, how each line on stderr begins
CASES = [
    (["--help"], 0, []),
    (["run", "--help"], 0, []),
    (["--version"], 0, []),
    ([], 2, ["A subcommand is required"]),
    (
        ["rnu", "a.yaml"],
        2,
        [
            "subcommand 'rnu': unknown, allowed run, check, cell, yarn, fabrics, projectiles, study, v50, partition, did you mean 'run'?"
        ],
    ),
    (
        ["explode"],
        2,
        [
            "subcommand 'explode': unknown, allowed run, check, cell, yarn, fabrics, projectiles, study, v50, partition"
        ],
    ),
    (["v50", "no_such_file.yaml"], 2, ["no_such_file.yaml: cannot be read: No such file or directory"]),
    (["study"], 2, [""]),
    (["study", "no_such_file.yaml"], 2, ["no_such_file.yaml: cannot be read: No such file or directory"]),
    (["partition", "a.yaml"], 2, ["partition: allowed is one of --ranks LIST and --calibrate FILE"]),
    (["run", "a.yaml", "--outptu", "d"], 2, ["option '--outptu': unknown, allowed --help, "]),
    (["run", "a.yaml", "--restart", "auto", "--overwrite"], 2, ["--overwrite excludes --restart"]),
    (
        ["run", "a.yaml", "--checkpoint-every", "10"],
        2,
        ["--checkpoint-every: found a number without a unit, allowed a time with its unit"],
    ),
    (
        ["run", "a.yaml", "--walltime", "0 s"],
        2,
        ["--walltime: found '0 s', allowed a time above 0, such as '2 h'"],
    ),
    (["run", "a.yaml", "--rebalance"], 2, ["--rebalance: 1 required"]),
    (["run", "a.yaml", "--rebalance", "-1"], 2, ["--rebalance: found '-1', allowed a number of at least 0"]),
    (
        ["run", "a.yaml", "--rebalance", "nan"],
        2,
        ["--rebalance: found 'nan', allowed a number of at least 0"],
    ),
    (
        ["yarn", "--rates", "", "a.yaml", "--out", "y.csv"],
        2,
        ["--rates: found '', allowed positive strain rates in 1/s, such as 1,10,100"],
    ),
    (
        ["yarn", "--rates", "1,,2", "a.yaml", "--out", "y.csv"],
        2,
        ["--rates: found '', allowed positive strain rates"],
    ),
    (
        ["yarn", "--rates", "0x10,1", "a.yaml", "--out", "y.csv"],
        2,
        ["--rates: found '0x10', allowed positive strain rates"],
    ),
    (
        ["yarn", "--rates", "1,nan,-2", "a.yaml", "--out", "y.csv"],
        2,
        ["--rates: found 'nan', ", "--rates: found '-2', "],
    ),
    (
        ["yarn", "--rates", "1,10", "no_such_file.yaml", "--out", "y.csv"],
        2,
        ["no_such_file.yaml: cannot be read"],
    ),
    (["--vresion"], 2, ["option '--vresion': unknown, allowed --help, --version, did you mean '--version'?"]),
    (["run"], 2, [""]),
    (["check", "folder"], 2, ["folder: cannot be read: Is a directory"]),
    (
        ["check", "study.yaml"],
        2,
        [
            "study.yaml:2:11: variants: found a study, allowed a scene; studies are computed by weavefront study"
        ],
    ),
    (
        ["study", "bad.yaml"],
        2,
        ["bad.yaml:2:10: fabrics: found a scene, allowed a study, which names its scene"],
    ),
    (["check", "no_such_file.yaml"], 2, ["no_such_file.yaml: cannot be read: No such file or directory"]),
    (
        ["check", "--set", "title=x", "--set", "fabrics.b.yarn=1", "bad.yaml"],
        2,
        [
            "bad.yaml:1:1: target: found nothing, allowed a map with keys size, ",
            "bad.yaml:1:1: time: found nothing, allowed a map with keys end, ",
            "bad.yaml:1:1: output: found nothing, allowed a map with keys interval, ",
            "bad.yaml:1:1: titel: found an unknown key, allowed title, ",
            "bad.yaml:2:14: fabrics.a: found '3', allowed a map with keys library, formulation, ",
            "--set fabrics.b.yarn=1: fabrics.b.yarn: found 'b', allowed the name of a fabric of the scene",
        ],
    ),
]


def call(*command, rank=None):
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("OMPI_COMM", "PMI"))}
    if rank is not None:
        environment["OMPI_COMM_WORLD_RANK"] = str(rank)
    return subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60)


def main():
    program, mpiexec = os.path.abspath(sys.argv[1]), sys.argv[2]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with open("bad.yaml", "w") as file:
            file.write(BAD_SCENE)
        with open("study.yaml", "w") as file:
            file.write("scene: bad.yaml\nvariants: []\n")
        os.mkdir("folder")
        for number, (arguments, status, beginnings) in enumerate(CASES):
            result = call(program, *arguments)
            lines = result.stderr.splitlines()
            assert result.returncode == status, (arguments, result)
            assert len(lines) == len(beginnings), (arguments, lines)
            for line, beginning in zip(lines, beginnings):
                assert line.startswith("weavefront: error: " + beginning), (arguments, line)
            assert bool(result.stdout) == (status == 0), (arguments, result.stdout)

            # What all ranks find alike is told by the first one. The others end in the same status, later: a
            # launcher that sees one fail kills the first before it has printed. Commands of one process leave
            # everything to the first.
            if number % 4 == 3 or status == 0:
                other_rank = call(program, *arguments, rank=1)
                others = 0 if arguments[:1] in (["check"], ["cell"], ["yarn"]) else status
                assert (other_rank.returncode, other_rank.stdout, other_rank.stderr) == (others, "", ""), (
                    arguments,
                    other_rank,
                )

            # A few cases show the same with ranks.
            if number % 5 > 0:
                continue
            together = call(mpiexec, "-n", "2", program, *arguments)
            told = [line for line in together.stderr.splitlines() if line.startswith("weavefront: ")]
            assert (together.returncode, told) == (status, lines), (arguments, together)
            assert status != 0 or together.stdout == result.stdout, (arguments, together.stdout)


main()
