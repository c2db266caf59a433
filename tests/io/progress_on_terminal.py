"""On a terminal progress stays on one line and other lines appear above it: progress_on_terminal.py SHOWER

Leaves with 77, which ctest counts as skipped, on a machine without pseudo-terminals (a bare chroot).
"""

import os
import pty
import sys

CLEAR = "\x1b[K"


def output_on_terminal(command):
    """What the command prints to a terminal."""
    try:
        pid, terminal = pty.fork()
    except OSError as missing:
        print("skipped:", missing)
        sys.exit(77)
    if pid == 0:
        os.execv(command[0], command)
    text = b""
    try:
        while chunk := os.read(terminal, 4096):
            text += chunk
    except OSError:  # Linux reports the end of a terminal so
        pass
    assert os.waitpid(pid, 0)[1] == 0
    return text.decode().replace("\r\n", "\n")


def main():
    lines = output_on_terminal(sys.argv[1:]).split("\n")
    assert len(lines) == 3 and lines[2] == "", lines
    # What stays of a line is what was drawn after its last clearing.
    drawn = [line.replace(CLEAR, "").split("\r") for line in lines]
    assert drawn[0][-1] == "a line in between", drawn[0]
    assert all(bar.startswith("[") for bar in drawn[0][1:-2]), drawn[0]
    assert "step 50 " in drawn[1][1], "the bar does not come back below the line"
    assert (
        drawn[1][-1] == "[####################] 100 %  100.00 of 100.00 us  step 100  projectile 212.4 m/s"
    ), drawn[1]
    assert drawn[1][-2].endswith("projectile 212.4 m/s  1 s left"), drawn[1][-2]


main()
