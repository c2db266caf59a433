"""Builds, their programs and the machine, as the measurements of this folder name them."""

import platform
import re
import subprocess
import sys
from pathlib import Path


def settings(overrides):
    return [word for override in overrides for word in ("--set", override)]


def run(command):
    """What the command prints; ends the program when it fails."""
    words = list(map(str, command))
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(words)}\n{done.stdout}{done.stderr}")
    return done.stdout


def processor():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return platform.machine()


def architecture(build):
    for line in (build / "CMakeCache.txt").read_text().splitlines():
        if line.startswith("WEAVEFRONT_ARCH:"):
            return line.split("=")[1]


def compiler(build):
    """Name and version, such as GNU 12.2.0."""
    text = next((build / "CMakeFiles").glob("*/CMakeCXXCompiler.cmake")).read_text()
    return " ".join(
        re.search(rf'set\(CMAKE_CXX_COMPILER_{word} "([^"]*)"\)', text).group(1) for word in ("ID", "VERSION")
    )
