"""The closed forms of synthetic_model.cpp, and the comparison of a file with them."""

import numpy as np

import vtkhdf

COLUMNS, ROWS, PLIES = 7, 5, 2
NODES = COLUMNS * ROWS * PLIES
ELEMENTS = (COLUMNS - 1) * (ROWS - 1) * PLIES
SURFACE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0]], dtype=float)
SURFACE_QUADS = np.array([[0, 1, 2, 3], [1, 4, 5, 2]])


def fabric(k):
    """Part 0 of frame k."""
    node, component = np.meshgrid(np.arange(NODES), np.arange(3), indexing="ij")
    value = 1000.0 * k + node + 0.25 * component
    element = np.arange(ELEMENTS)
    ply, cell = np.divmod(element, ELEMENTS // PLIES)
    corner = ply * COLUMNS * ROWS + cell // (COLUMNS - 1) * COLUMNS + cell % (COLUMNS - 1)
    return {
        "points": value,
        "quads": np.stack([corner, corner + 1, corner + COLUMNS + 1, corner + COLUMNS], axis=1),
        "point_data": {"displacement": value + 0.125, "velocity": -value},
        "cell_data": {
            "strain_fill": k + 0.0625 * element,
            "broken_fill": ((element + k) % 3 == 0).astype(np.int8),
            "vtkGhostType": np.where((element + k) % 5 == 0, 32, 0).astype(np.uint8),
            "ply": (ply + 1).astype(np.int32),
        },
    }


def projectile(k):
    """Part 1 of frame k."""
    points, cells = len(SURFACE), len(SURFACE_QUADS)
    return {
        "points": SURFACE + [0, 0.25, -k],
        "quads": SURFACE_QUADS,
        "point_data": {
            "displacement": np.tile([1.0 * k, 2.0 * k, 3.0 * k], (points, 1)),
            "velocity": np.zeros((points, 3)),
        },
        "cell_data": {
            "strain_fill": np.zeros(cells),
            "broken_fill": np.zeros(cells, np.int8),
            "vtkGhostType": np.zeros(cells, np.uint8),
            "ply": np.zeros(cells, np.int32),
        },
    }


def same(read, expected):
    """Whether two nested dictionaries of arrays are equal, types of the cell data included."""
    if isinstance(expected, dict):
        return read.keys() == expected.keys() and all(same(read[key], expected[key]) for key in expected)
    return np.array_equal(read, expected) and np.asarray(read).dtype == np.asarray(expected).dtype


def check_frames(path, with_projectile=True, surplus_times=0):
    """Reads every frame of the file; returns their number. Raises AssertionError at the first value that is
    wrong."""
    with vtkhdf.Reader(path) as reader:
        assert reader.surplus_times <= surplus_times, f"{path}: {reader.surplus_times} more times than frames"
        for k in range(reader.steps):
            time, parts = reader.frame(k)
            expected = [fabric(k)] + ([projectile(k)] if with_projectile else [])
            assert time == 0.5 * k, (path, k, time)
            assert len(parts) == len(expected), (path, k, len(parts))
            for part, (got, want) in enumerate(zip(parts, expected)):
                assert same(got, want), f"{path}: frame {k}, part {part} differs"
        return reader.steps
