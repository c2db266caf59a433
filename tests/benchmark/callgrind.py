"""Instructions of a program as Callgrind counts them."""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HEAP = re.compile(r"\b(malloc|calloc|realloc|aligned_alloc|memalign|posix_memalign|operator new)\b")


class Counts:
    """Instructions by function: (count, function, object)."""

    def __init__(self, functions):
        self.functions = functions

    def total(self, but_objects=()):
        """Of all functions, without those of objects (libraries) whose path holds one of the words."""
        return sum(
            count for count, _, where in self.functions if not any(word in where for word in but_objects)
        )

    def of(self, name):
        """Of the functions whose name begins so."""
        return sum(count for count, function, _ in self.functions if function.startswith(name))

    def calls_the_heap(self):
        return any(HEAP.search(function) for _, function, _ in self.functions)


def require():
    """Ends the program when valgrind is missing."""
    if not shutil.which("valgrind") or not shutil.which("callgrind_annotate"):
        sys.exit(
            "valgrind not found: it counts the instructions. It is needed for this table only: apt-get install valgrind"
        )


def read(path, inclusive):
    text = subprocess.run(
        [
            "callgrind_annotate",
            "--threshold=100",
            "--auto=no",
            f"--inclusive={'yes' if inclusive else 'no'}",
            str(path),
        ],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    functions = []
    for line in text.splitlines():
        found = re.match(r"\s*([\d,]+) \([^)]*%\)\s+[^:]*:(.*?)(?: \[([^\]]*)\])?$", line)
        if found and found.group(2) != "function":
            functions.append((int(found.group(1).replace(",", "")), found.group(2), found.group(3) or ""))
    return Counts(functions)


def count(command, launcher=(), within=None):
    """Runs the command; one Counts a process, and what the command printed.

    within  function to collect in, callees included; None: the whole program, counts inclusive of callees"""
    with tempfile.TemporaryDirectory() as folder:
        tool = ["valgrind", "--quiet", "--tool=callgrind", f"--callgrind-out-file={folder}/%p"]
        if within:
            tool += ["--collect-atstart=no", f"--toggle-collect={within}"]
        done = subprocess.run([*launcher, *tool, *command], capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
        return [read(path, inclusive=within is None) for path in sorted(Path(folder).iterdir())], done.stdout


def traffic(command, within, cache="1048576,16,64"):
    """Runs the command on a simulated cache; instructions, and bytes read into that cache and written back
    from it.

    cache  size, associativity, line: the last level; nothing behind it is simulated"""
    levels = [f"--{level}=32768,8,64" for level in ("I1", "D1")]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "out"
        tool = [
            "valgrind",
            "--quiet",
            "--tool=callgrind",
            f"--callgrind-out-file={path}",
            "--cache-sim=yes",
            "--simulate-wb=yes",
            *levels,
            f"--LL={cache}",
            "--collect-atstart=no",
            f"--toggle-collect={within}",
        ]
        printed = subprocess.run([*tool, *command], capture_output=True, text=True, check=True).stdout
        words = {
            line.split()[0]: line.split()[1:]
            for line in path.read_text().splitlines()
            if line.startswith(("events:", "totals:"))
        }
    count = {event: int(value) for event, value in zip(words["events:"], words["totals:"])}
    lines = sum(count.get(event, 0) for event in ("DLmr", "DLmw", "ILdmr", "DLdmr", "DLdmw"))
    return count["Ir"], lines * int(cache.split(",")[2]), printed
