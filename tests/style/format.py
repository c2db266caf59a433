"""Every C++ file is as clang-format leaves it. Other releases of clang-format break lines elsewhere, so without release 14 the check skips."""

import re
import shutil
import subprocess
import sys

from sources import CPP, report, sources

RELEASE = "14"
SKIPPED = 77


def find_formatter():
    """Path of clang-format 14, or None."""
    for name in [f"clang-format-{RELEASE}", "clang-format"]:
        path = shutil.which(name)
        if path and re.search(rf"version {RELEASE}\.", subprocess.run([path, "--version"], capture_output=True, text=True).stdout):
            return path
    return None


def main():
    formatter = find_formatter()
    if not formatter:
        print(f"clang-format {RELEASE} not found: format not checked")
        return SKIPPED
    files = sources(CPP)
    checked = subprocess.run([formatter, "--dry-run", "-Werror", *files], capture_output=True, text=True)
    first = re.findall(r"^(.+?:\d+:\d+): error:", checked.stderr, re.MULTILINE)
    if checked.returncode and not first:
        first = [checked.stderr]
    return report([f"{place}: not formatted, run clang-format -i" for place in first], len(files))


sys.exit(main())
