"""The project's own source files, as the style checks see them."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ["include", "src", "partition", "tests", "examples", "cmake", ".ci"]
CPP = {".hpp", ".cpp"}
CODE = CPP | {".py", ".cmake", ".sh"}


def has_suffix(path, suffixes):
    """Whether the file is of one of the kinds; a file without suffix counts as what its first line says."""
    if path.suffix:
        return path.suffix in suffixes
    with path.open("rb") as file:
        return ".sh" in suffixes and file.read(2) == b"#!"


def sources(suffixes):
    """Sorted paths of the source files with one of the suffixes."""
    found = (path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.is_file())
    return sorted(path for path in found if has_suffix(path, suffixes))


def report(defects, checked):
    """Prints the defects and the count of what was checked; returns the exit status. Nothing checked is a
    defect."""
    for defect in defects:
        print(defect)
    print(f"{checked} checked, {len(defects)} at fault")
    return 1 if defects or not checked else 0
