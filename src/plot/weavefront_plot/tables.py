"""CSV files with a header line, as columns of numbers in SI."""
import csv
import io
import stat
from array import array

import numpy as np

from .failure import FileError, InputError
from .option_values import short

LARGEST_FILE = 1 << 30  # bytes
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
    rows = rows_of(path, text)
    names = [name.strip() for name in next(rows, (0, []))[1]]
    if not names:
        raise InputError(f"{path}: empty, expected a header line")
    for name in required:
        if name not in names:
            raise InputError(f"{path}: no column '{name}'; it has {', '.join(map(short, names[:60]))}")
    wanted = [name for name in (*required, *optional) if name in names]
    for name in wanted:
        if names.count(name) > 1:
            raise InputError(f"{path}: two columns '{name}'")
    places, table = [names.index(name) for name in wanted], array("d")
    for line, row in rows:
        table.extend(numbers(path, line, names, row, places))
    if not table:
        raise InputError(f"{path}: no rows below the header")
    return dict(zip(wanted, np.array(table).reshape(-1, len(wanted)).T))


def rows_of(path, text):
    """Number and values of each line that is neither empty nor a comment."""
    reader = csv.reader(io.StringIO(text, newline=""))
    try:
        for row in reader:
            if row and not row[0].lstrip().startswith("#"):
                yield reader.line_num, row
    except csv.Error as error:
        raise InputError(f"{path}:{reader.line_num}: {error}") from None


def numbers(path, line, names, row, places):
    """The values of the row in these places as floats."""
    if len(row) != len(names):
        raise InputError(
            f"{path}:{line}: '{short(','.join(row))}' has {len(row)} values, the header {len(names)}"
        )
    values = []
    for place in places:
        try:
            value = float(row[place])
        except ValueError:
            raise InputError(
                f"{path}:{line}: {names[place]}: '{short(row[place])}' is not a number"
            ) from None
        if not abs(value) <= LARGEST:
            raise InputError(
                f"{path}:{line}: {names[place]}: {short(row[place].strip())} is not finite or beyond {LARGEST:g}"
            )
        values.append(value)
    return values
