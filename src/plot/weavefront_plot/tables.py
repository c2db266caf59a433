"""CSV files with a header line, as columns of numbers in SI."""
import csv

import numpy as np

from .failure import FileError, InputError


def read_columns(path, required=()):
    """The columns of `path` by name. A last line cut short (the run was killed) is left out."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            lines = [line for line in csv.reader(file) if line and not line[0].lstrip().startswith("#")]
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise InputError(f"{path}: not a text file") from None
    if not lines:
        raise InputError(f"{path}: empty, expected a header line")
    names = [name.strip() for name in lines[0]]
    for name in required:
        if name not in names:
            raise InputError(f"{path}: no column '{name}'; it has {', '.join(names)}")
    rows = lines[1:]
    if rows and len(rows[-1]) < len(names):
        rows.pop()
    if not rows:
        raise InputError(f"{path}: no rows below the header")
    return dict(zip(names, np.array([numbers(path, names, row) for row in rows]).T))


def numbers(path, names, row):
    """The row as floats."""
    if len(row) != len(names):
        raise InputError(f"{path}: '{','.join(row)[:60]}' has {len(row)} values, the header {len(names)}")
    try:
        return [float(value) for value in row]
    except ValueError as error:
        raise InputError(f"{path}: {str(error).removeprefix('could not convert string to float: ')} is not a number") from None
