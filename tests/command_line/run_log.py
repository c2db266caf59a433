"""run.log begins with when, where and how the run was started and ends with how long it took; what lies
between is what was printed: run_log.py WEAVEFRONT SCENE MPIEXEC"""

import datetime
import re
import socket
import subprocess
import sys
import tempfile
from pathlib import Path

TIME = r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d [-+]\d{4}"


def run(folder, name, *command):
    done = subprocess.run(
        [str(word) for word in (*command, "--output", folder / name)],
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0, done
    return (folder / name / "run.log").read_text().splitlines(), done


def check_head_and_end(log, words, ranks):
    started = re.fullmatch(rf"  started       ({TIME})", log[0])
    ended = re.fullmatch(rf"  ended         ({TIME}), after (\d+\.\d\d s|.* min .*)", log[-1])
    assert started and ended, (log[0], log[-1])
    times = [datetime.datetime.strptime(found.group(1), "%Y-%m-%d %H:%M:%S %z") for found in (started, ended)]
    assert (
        times[0] <= times[1] <= datetime.datetime.now(datetime.timezone.utc) + datetime.timedelta(seconds=1)
    ), times
    assert log[1] == f"  hosts         {socket.gethostname()} ({ranks} rank{'s' if ranks > 1 else ''})", log[
        1
    ]
    assert log[2] == f"  command       {words}", log[2]
    assert re.fullmatch(r"  revision      [-A-Za-z0-9._+]+", log[3]), log[3]


def main():
    program, scene, mpiexec = sys.argv[1:]
    small = [
        "target.mesh.center=4 mm",
        "target.mesh.edge=4 mm",
        "target.plies.count=1",
        "time.end=2 us",
        "output.interval=0",
        "title=it's",
    ]
    options = [word for override in small for word in ("--set", override)]
    quoted = (
        " ".join(f"--set '{override}'" if " " in override else f"--set {override}" for override in small[:-1])
        + " --set 'title=it'\\''s'"
    )
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        log, done = run(folder, "one", program, "run", scene, *options)
        check_head_and_end(log, f"{program} run {scene} {quoted} --output {folder}/one", 1)
        # On a screen warnings go to standard error; the file has both, in order.
        shown = done.stdout.splitlines()
        assert [line for line in log[4:-1] if not line.startswith("warning: ")] == shown, (log, shown)
        assert log[4] == "Weavefront 0.1.0: it's" and log[-2] == f"  results       {folder}/one", log
        log, done = run(folder, "two", mpiexec, "-n", "2", program, "run", scene, *options)
        check_head_and_end(log, f"{program} run {scene} {quoted} --output {folder}/two", 2)
        # Nothing of it is in the results.
        assert (folder / "one/history.csv").read_bytes() == (folder / "two/history.csv").read_bytes()
        for text in (b"started", b"revision", socket.gethostname().encode()):
            assert (
                text not in (folder / "one/results.vtkhdf").read_bytes()
                and text not in (folder / "one/history.csv").read_bytes()
            ), text


main()
