"""An HDF5 file that may be damaged: every fault becomes one Failure that names file and object."""
from contextlib import contextmanager

import h5py
import numpy as np

from .failure import FileError, InputError

COMPRESSION = 1032  # deflate shrinks no array more than this
INTEGER, NUMBER = "iu", "iuf"  # kinds of numpy types
LONGEST_TEXT = 1 << 24  # bytes
ROWS = 1 << 60  # more than any array has, and far from where sums of 64 bits overflow


class Hdf5Reader:
    """Checked reads of parts of arrays."""

    def __init__(self, path):
        self.path = path
        if not path.exists():
            raise FileError(f"{path}: no such file")
        if not path.is_file():
            raise FileError(f"{path}: not a file")
        try:
            self.file = h5py.File(path, "r")
        except OSError:
            raise FileError(f"{path}: not a readable HDF5 file") from None
        self.size = path.stat().st_size

    @contextmanager
    def _reading(self, name):
        """Turns what h5py throws into a Failure."""
        try:
            yield
        except OSError as error:
            raise FileError(f"{self.path}: {name}: cannot be read: {error.strerror or error}") from None
        except KeyError:
            raise InputError(f"{self.path}: no {name}") from None
        except (AttributeError, OverflowError, RuntimeError, TypeError, ValueError) as error:
            raise InputError(f"{self.path}: {name}: cannot be read: {error}") from None

    def dataset(self, name):
        """The array of this name."""
        with self._reading(name):
            found = self.file[name]
            if not isinstance(found, h5py.Dataset) or found.shape is None or found.dtype is None:
                raise InputError(f"{self.path}: {name} is not an array")
            return found

    def has(self, name):
        """Whether there is an object of this name."""
        with self._reading(name):
            return name in self.file

    def arrays(self, group):
        """Names of the arrays in a group, sorted; none where it is missing."""
        with self._reading(group):
            found = self.file.get(group)
            names = sorted(found) if isinstance(found, h5py.Group) else []
            return [name for name in names if isinstance(found.get(name), h5py.Dataset)]

    def count(self, group, attribute):
        """An attribute that is a whole number."""
        with self._reading(f"{group}, attribute {attribute}"):
            value = np.asarray(self.file[group].attrs[attribute])
        if value.size != 1 or value.dtype.kind not in INTEGER:
            raise InputError(f"{self.path}: {group}: attribute {attribute} is not a whole number")
        return int(value.reshape(()))

    def number(self, name, row):
        """One whole number of an array."""
        value = int(self.rows(name, row, 1, INTEGER)[0])
        if not 0 <= value <= ROWS:
            raise InputError(f"{self.path}: {name} holds {value}, which is no row of an array")
        return value

    def text(self, name):
        """The text that an array of bytes holds, nothing where it is missing."""
        if not self.has(name):
            return ""
        array = self.dataset(name)
        if array.dtype.kind not in "SuO" or array.size * array.dtype.itemsize > LONGEST_TEXT:
            raise InputError(f"{self.path}: {name} is not text")
        with self._reading(name):
            return np.asarray(array[()]).tobytes().decode("utf-8", "replace")

    def all(self, name, kinds, limit):
        """A whole array of at most `limit` rows."""
        array = self.dataset(name)
        rows = array.shape[0] if array.ndim else 0
        if rows > limit:
            raise InputError(f"{self.path}: {name} has {rows} rows, more than {limit}")
        return self.rows(name, 0, rows, kinds)

    def rows(self, name, first, count, kinds=NUMBER, width=None, largest=1e100):
        """Rows [first, first + count) as int64 or float64, of `width` numbers each or of one.

        Magnitudes beyond `largest`, and what is not finite, are refused.
        """
        array = self.dataset(name)
        first, count, shape = int(first), int(count), (width,) if width else ()
        if array.dtype.kind not in kinds or array.ndim < 1 or array.shape[1:] not in (shape, shape or (1,)):
            raise InputError(
                f"{self.path}: {name} is of shape {array.shape} and type {array.dtype}, expected rows of {width or 1} "
                f"{'number' if 'f' in kinds else 'whole number'}{'s' if width else ''}"
            )
        if not 0 <= first <= first + count <= array.shape[0]:
            raise InputError(f"{self.path}: {name} ends before its last frame")
        needed = count * (width or 1) * array.dtype.itemsize
        if needed > self.size * (COMPRESSION if array.compression else 1):
            raise InputError(f"{self.path}: {name} asks for {needed} bytes, the file has {self.size}")
        with self._reading(name):
            values = array[first : first + count].reshape((count, *shape))
        if array.dtype.kind in INTEGER:
            return values.astype(np.int64)
        values = values.astype(np.float64)
        if not np.all(np.abs(values) <= largest):  # false for NaN
            raise InputError(f"{self.path}: {name} holds values that are not finite or beyond {largest:g}")
        return values
