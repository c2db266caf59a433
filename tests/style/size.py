"""No source file is longer than 500 lines."""

import sys

from sources import CODE, ROOT, report, sources

LIMIT = 500


def main():
    lengths = {path: len(path.read_text().splitlines()) for path in sources(CODE)}
    defects = [
        f"{path.relative_to(ROOT)}: {length} lines, allowed are {LIMIT}"
        for path, length in lengths.items()
        if length > LIMIT
    ]
    return report(defects, len(lengths))


sys.exit(main())
