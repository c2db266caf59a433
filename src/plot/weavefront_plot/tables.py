"""CSV files with a header line, as columns of numbers in SI."""
import csv
import io
import stat

import numpy as np

from .failure import FileError, InputError
from .option_values import short

LARGEST_FILE = 1 << 28  # bytes
LARGEST = 1e100  # magnitude of a number that can be drawn


def read_text(path):
    """The text of a file; it may be a pipe."""
    try:
        with open(path, "rb") as file:
            if stat.S_ISCHR(path.stat().st_mode):
                raise InputError(f"{path}: a device, not a file")
            data = file.read(LARGEST_FILE + 1)
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from None
    if len(data) > LARGEST_FILE:
        raise InputError(f"{path}: larger than {LARGEST_FILE >> 20} MiB")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{path}: not a text file (UTF-8)") from None


def read_columns(path, required=(), optional=(), growing=False):
    """The columns `required`, and `optional` where they are, by name; others may hold anything.

    `growing`: the file of a run, which may be going on; a last line that is not complete is left out.
    """
    text = read_text(path)
    if growing:
        text = text[: text.rfind("\n") + 1]
    lines = rows_of(path, text)
    if not lines:
        raise InputError(f"{path}: empty, expected a header line")
    names = [name.strip() for name in lines[0][1]]
    for name in required:
        if name not in names:
            raise InputError(f"{path}: no column '{name}'; it has {', '.join(map(short, names[:60]))}")
    wanted = [name for name in (*required, *optional) if name in names]
    for name in wanted:
        if names.count(name) > 1:
            raise InputError(f"{path}: two columns '{name}'")
    if not lines[1:]:
        raise InputError(f"{path}: no rows below the header")
    places = [names.index(name) for name in wanted]
    table = np.array([numbers(path, line, names, row, places) for line, row in lines[1:]])
    return dict(zip(wanted, table.T))


def rows_of(path, text):
    """Number and values of each line that is neither empty nor a comment."""
    reader = csv.reader(io.StringIO(text, newline=""))
    rows = []
    try:
        for row in reader:
            if row and not row[0].lstrip().startswith("#"):
                rows.append((reader.line_num, row))
    except csv.Error as error:
        raise InputError(f"{path}:{reader.line_num}: {error}") from None
    return rows


def numbers(path, line, names, row, places):
    """The values of the row in these places as floats."""
    if len(row) != len(names):
        raise InputError(f"{path}:{line}: '{short(','.join(row))}' has {len(row)} values, the header {len(names)}")
    values = []
    for place in places:
        try:
            value = float(row[place])
        except ValueError:
            raise InputError(f"{path}:{line}: {names[place]}: '{short(row[place])}' is not a number") from None
        if not abs(value) <= LARGEST:
            raise InputError(f"{path}:{line}: {names[place]}: {short(row[place].strip())} is not finite or beyond {LARGEST:g}")
        values.append(value)
    return values
