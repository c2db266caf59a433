"""Every C++ file is as clang-format leaves it, every Python file as black leaves it.

Other releases break lines elsewhere. So a formatter of another release checks nothing.
"""

import re
import shutil
import subprocess
import sys

from sources import CPP, report, sources

SKIPPED = 77
# Of each language: release, names of the program, options to check, and the start of a line about a file.
CLANG_FORMAT = (
    "14",
    ["clang-format-14", "clang-format"],
    ["--dry-run", "-Werror"],
    r"^(.+?:\d+:\d+): error:",
)
BLACK = ("23", ["black"], ["--check", "--line-length", "110"], r"^would reformat (.+)$")


def find(release, names):
    """Path of the formatter, or None without one of that release."""
    for path in filter(None, map(shutil.which, names)):
        version = subprocess.run([path, "--version"], capture_output=True, text=True).stdout
        if re.search(rf"(version|black,) {release}\.", version):
            return path
    return None


def defects(formatter, options, at_fault, files):
    """Places that the formatter would change; its whole message if it names none."""
    checked = subprocess.run([formatter, *options, *files], capture_output=True, text=True)
    places = re.findall(at_fault, checked.stderr, re.MULTILINE)
    if checked.returncode and not places:
        places = [checked.stderr]
    return [f"{place}: not formatted, see CONTRIBUTING.md" for place in places]


def main():
    found, files_checked = [], 0
    for (release, names, options, at_fault), suffixes in [(CLANG_FORMAT, CPP), (BLACK, {".py"})]:
        formatter = find(release, names)
        if not formatter:
            print(f"{names[-1]} {release} not found: its files are not checked")
            continue
        files = sources(suffixes)
        files_checked += len(files)
        found += defects(formatter, options, at_fault, files)
    return report(found, files_checked) if files_checked else SKIPPED


sys.exit(main())
