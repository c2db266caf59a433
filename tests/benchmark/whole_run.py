"""Speed of whole runs, in figures that a user meets: whole_run.py BUILD [--counted BUILD]

BUILD is a release build for this machine with the targets weavefront, benchmark_step and benchmark_kernels.
--counted is one of
-DWEAVEFRONT_ARCH=x86-64-v3 with the last two, for instructions and bytes; BUILD/x86-64-v3 unless named.
Writes whole_run.json and whole_run.md beside this script. Wants an idle machine of two cores: what it times
is in seconds."""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import callgrind
from programs import architecture, compiler, processor, run, settings

HERE = Path(__file__).parent
EXAMPLES = HERE.parent.parent / "examples"
SCENE = EXAMPLES / "kevlar129_8ply/impact_267.yaml"
NO_PLY_CONTACT = ["contact={projectile: {stiffness: 5.6e12 N/m^3, unloading: 10}}"]
FINER = ["target.mesh={center: 0.5 mm, edge: 1 mm, growth: 1.08}"]
SCALING = EXAMPLES / "scaling/scene.yaml"
CUT = ["time.end=20 us", "output.interval=0", "output.history=20 us"]
STEP_PHASES = ("elements", "contact", "search", "halo", "integrate", "ledger")
STEPS = 20  # of benchmark_step, after 20 to warm up
CONNECTIVITY = 4 * 4  # bytes: four nodes of an element, 32 bits each
TARGETS = {"memory": 400, "two_ranks": 0.95, "output": 0.05, "AVX-512": 3.5, "AVX2": 3.0}


def summary_of(commands):
    """Runs `weavefront run` commands side by side, each with a place for its output; their summaries."""
    with tempfile.TemporaryDirectory() as folder:
        places = [Path(folder) / str(n) for n in range(len(commands))]
        started = [
            subprocess.Popen(
                [*map(str, command), "--output", str(place)],
                stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE,
                text=True,
            )
            for command, place in zip(commands, places)
        ]
        for one in started:
            _, error = one.communicate()
            if one.returncode:
                sys.exit(f"{' '.join(one.args)}\n{error}")
        return [json.loads((place / "summary.json").read_text()) for place in places]


def step_seconds(summary):
    return sum(summary["wall_seconds"][phase]["max"] for phase in STEP_PHASES)


def one_rank(command, overrides, repeats):
    """Nanoseconds an element-step by phase, of the fastest of the runs."""
    runs = [summary_of([[*command, *settings(overrides)]])[0] for _ in range(repeats)]
    best = min(runs, key=step_seconds)
    phases = {
        phase: best["wall_seconds"][phase]["max"] * 1e9 / best["element_steps"] for phase in STEP_PHASES
    }
    return {
        "nanoseconds": sum(phases.values()),
        "phases": phases,
        "elements": best["elements"],
        "steps": best["steps"],
    }


def run_words(build, overrides, scene=SCENE):
    return [build / "src/app/weavefront", "run", scene, *settings(overrides)]


def begin(words):
    return subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def printed(started):
    """What a `benchmark_step` prints at its end."""
    output, error = started.communicate()
    if started.returncode:
        sys.exit(f"{' '.join(started.args)}\n{error}")
    return json.loads(output)


def least_seconds(runs):
    """Of all steps, each as fast as it was in any of the runs."""
    return sum(map(min, zip(*(run["seconds"] for run in runs))))


def two_ranks(command, repeats):
    """Throughput of two ranks over that of two runs of one rank side by side, by turns. All take the same
    steps each time, and what else goes on in the machine only ever makes a step longer: so a step counts with
    the least time that it took. `pairs` are the ratios of single pairs as they came: two ranks wait for
    whichever core is disturbed, two runs do not."""
    processors = sorted(os.sched_getaffinity(0))[:2]
    if len(processors) < 2:
        sys.exit("two ranks are compared on two cores; this process may use one only")
    pinned = [["taskset", "-c", str(core), *map(str, command)] for core in processors]
    together = ["mpirun", "--bind-to", "none", "-n", "1", *pinned[0], ":", "-n", "1", *pinned[1]]
    both, apart = [], []
    for _ in range(repeats):
        both.append(printed(begin(together)))
        apart.append([printed(started) for started in [begin(words) for words in pinned]])

    def ratio(together, *alone):
        return 1 / least_seconds(together) / sum(1 / least_seconds(runs) for runs in alone)

    return {
        "elements": apart[0][0]["elements"],
        "steps": apart[0][0]["steps"],
        "ratio": ratio(both, *zip(*apart)),
        "pairs": [ratio([one], *([run] for run in others)) for one, others in zip(both, apart)],
        "least_seconds": {
            "two ranks": least_seconds(both),
            "one rank": list(map(least_seconds, zip(*apart))),
        },
    }


def output_share(build):
    """Of a default run of full length on two ranks."""
    (summary,) = summary_of([["mpirun", "-n", 2, *run_words(build, [])]])
    seconds = {phase: time["max"] for phase, time in summary["wall_seconds"].items()}
    return {"share": seconds["output"] / sum(seconds.values()), "seconds": seconds}


def step_command(build, overrides):
    return [build / "tests/benchmark/benchmark_step", SCENE, *settings(overrides), "--steps", STEPS]


def shot_command(build, overrides, steps, scene=SCENE):
    """The scene itself from its beginning on: the plies at rest, the projectile on its way."""
    return [
        build / "tests/benchmark/benchmark_step",
        scene,
        *settings(overrides),
        "--warm-up",
        0,
        "--speed",
        0,
        "--steps",
        steps,
    ]


def kernels(build, repeats):
    """Best items (or bytes) a second of each benchmark."""
    program = build / "tests/benchmark/benchmark_kernels"
    report = json.loads(
        run(
            [
                program,
                "--benchmark_format=json",
                f"--benchmark_repetitions={repeats}",
                "--benchmark_enable_random_interleaving=true",
            ]
        )
    )
    best = {}
    for entry in report["benchmarks"]:
        if entry["run_type"] == "iteration":
            if "error_message" in entry:
                sys.exit(f"{entry['run_name']}: {entry['error_message']}")
            rate = entry.get("items_per_second", entry.get("bytes_per_second"))
            best[entry["run_name"]] = max(best.get(entry["run_name"], 0), rate)
    return best


def roofline(build, overrides, rates, repeats):
    """What the step takes over the least that its instructions and its bytes could take."""
    command = step_command(build, overrides)
    instructions, bytes_moved, printed = callgrind.traffic(list(map(str, command)), "measured_steps")
    element_steps = json.loads(printed)["elements"] * STEPS
    result = {
        "instructions": instructions / element_steps,
        "bytes": bytes_moved / element_steps,
        "nanoseconds": min(json.loads(run(command))["nanoseconds"] for _ in range(repeats)),
    }
    result["nanoseconds_of_instructions"] = result["instructions"] / rates["arithmetic"] * 1e9
    result["nanoseconds_of_bytes"] = result["bytes"] / rates["triad"] * 1e9
    least = max(result["nanoseconds_of_instructions"], result["nanoseconds_of_bytes"])
    result["binds"] = "instructions" if least == result["nanoseconds_of_instructions"] else "bandwidth"
    result["factor"] = result["nanoseconds"] / least
    return result


def registers(build):
    """Name of the vector registers that a build uses: what the compiler defines for its -march."""
    defined = run(["c++", f"-march={architecture(build)}", "-dM", "-E", "-x", "c++", "/dev/null"])
    return "AVX-512" if "__AVX512F__" in defined else "AVX2"


def measure(build, counted, repeats):
    load = round(os.getloadavg()[0], 2)  # of others, before anything runs here
    cases = {"with ply contact": [], "without ply contact": NO_PLY_CONTACT}
    rates = {registers(counted): kernels(counted, repeats)}
    counted_rates = rates[registers(counted)]
    if registers(build) not in rates:
        rates[registers(build)] = kernels(build, repeats)
    return {
        "machine": {"processor": processor(), "cores": len(os.sched_getaffinity(0)), "load": load},
        "build": {"compiler": compiler(build), "arch": architecture(build), "registers": registers(build)},
        "targets": TARGETS,
        "one_rank": {
            **{
                name: one_rank(run_words(build, []), [*CUT, *overrides], repeats)
                for name, overrides in cases.items()
            },
            "with ply contact, the whole example": one_rank(run_words(build, []), [], 2),
        },
        "two_ranks": [
            two_ranks(shot_command(build, [], 600), 8 * repeats),
            two_ranks(shot_command(build, FINER, 300), 3 * repeats),
            two_ranks(shot_command(build, [], 20, SCALING), 2 * repeats),
        ],
        "output": output_share(build),
        "memory": {
            name: json.loads(run(step_command(build, overrides)))["bytes"] - CONNECTIVITY
            for name, overrides in cases.items()
        },
        "kernels": rates,
        "roofline": {
            name: roofline(counted, overrides, counted_rates, repeats) for name, overrides in cases.items()
        },
    }


def rows(table):
    return "\n".join("| " + " | ".join(row) + " |" for row in table)


def kernel_rows(kernels_of):
    names = sorted(next(iter(kernels_of.values())))
    table = [[name, *(f"{rates[name] / 1e6:.4g}" for rates in kernels_of.values())] for name in names]
    for kernel in ("crimp", "cell"):
        table.append(
            [
                f"{kernel}: pack over scalar (target: at least {', '.join(str(TARGETS[r]) for r in kernels_of)})",
                *(
                    f"{rates[f'{kernel}/pack'] / rates[f'{kernel}/scalar']:.2f}"
                    for rates in kernels_of.values()
                ),
            ]
        )
    return rows([["million items a second", *kernels_of], ["---"] * (len(kernels_of) + 1), *table])


def roofline_text(figures, rates):
    lines = [
        f"The processor does {rates['arithmetic'] / 1e9:.1f} vector additions and multiplications a nanosecond; memory gives "
        f"{rates['triad'] / 1e9:.1f} GB/s (triad).",
        "",
    ]
    for name, r in figures.items():
        lines.append(
            f"- {name}: {r['instructions']:.0f} instructions and {r['bytes']:.0f} bytes an element-step, which take at least "
            f"{r['nanoseconds_of_instructions']:.0f} ns and {r['nanoseconds_of_bytes']:.0f} ns. Measured: {r['nanoseconds']:.0f} ns, "
            f"**{r['factor']:.1f}** times the limit that binds, {r['binds']}."
        )
    return "\n".join(lines)


def page(result):
    one = result["one_rank"]
    template = (HERE / "whole_run.md.in").read_text()
    return template.format(
        **result["machine"],
        **result["build"],
        targets=TARGETS,
        elements=one["without ply contact"]["elements"],
        one_rank=rows(
            [name, *(f"{case['phases'][p]:.1f}" for p in STEP_PHASES), f"**{case['nanoseconds']:.1f}**"]
            for name, case in one.items()
        ),
        steps=STEPS,
        two_ranks=rows(
            [
                str(case["elements"]),
                str(case["steps"]),
                f"**{case['ratio']:.3f}**",
                f"{statistics.median(case['pairs']):.2f}",
                f"{min(case['pairs']):.2f} to {max(case['pairs']):.2f}",
            ]
            for case in result["two_ranks"]
        ),
        output=f"{result['output']['share']:.2%}",
        memory=rows([name, f"{value:.0f}"] for name, value in result["memory"].items()),
        kernels=kernel_rows(result["kernels"]),
        roofline=roofline_text(result["roofline"], result["kernels"]["AVX2"]),
        output_target=f"{TARGETS['output']:.0%}",
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path)
    parser.add_argument("--counted", type=Path, help="build of x86-64-v3 (BUILD/x86-64-v3)")
    parser.add_argument("--output", type=Path, default=HERE / "whole_run.json")
    parser.add_argument("--page", type=Path, default=HERE / "whole_run.md")
    parser.add_argument("--repeats", type=int, default=5)
    options = parser.parse_args()
    callgrind.require()
    counted = options.counted or (
        options.build if architecture(options.build) == "x86-64-v3" else options.build / "x86-64-v3"
    )
    if architecture(counted) != "x86-64-v3":
        sys.exit(
            f"{counted} is built for {architecture(counted)}: configure with -DWEAVEFRONT_ARCH=x86-64-v3, since valgrind knows no AVX-512"
        )
    result = measure(options.build, counted, options.repeats)
    options.output.write_text(json.dumps(result, indent=2) + "\n")
    options.page.write_text(page(result))
    print(options.page.read_text())


if __name__ == "__main__":
    main()
