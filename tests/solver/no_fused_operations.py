"""A fused multiply-add rounds once where others round twice: with one the bits would depend on the build.
no_fused_operations.py WEAVEFRONT"""

import re
import shutil
import subprocess
import sys

SKIPPED = 77


def main():
    if shutil.which("objdump") is None:
        print("objdump is not installed")
        return SKIPPED
    code = subprocess.run(
        ["objdump", "-d", "--no-show-raw-insn", sys.argv[1]], check=True, capture_output=True, text=True
    ).stdout
    function, fused = "", set()
    for line in code.splitlines():
        if head := re.match(r"[0-9a-f]+ <(.*)>:$", line):
            function = head[1]
        elif re.search(r"\tvfn?m(add|sub)", line):
            fused.add(function)
    for name in sorted(fused):
        print(f"fused multiply-add in {name}")
    return 1 if fused else 0


sys.exit(main())
