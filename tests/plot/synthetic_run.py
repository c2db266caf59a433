#!/usr/bin/python3
"""Writes the folder of a run that was never computed: a whole, half or quarter model of plies deflected to an
exact pyramid.

The height falls linearly with |x| + |y| about the impact from a flat top that covers the projectile, so its
half-height contour is a square on its corner: its extent along x is sqrt(2) times that along the diagonal.

With --perforate the plies break one after another before the projectile. With `debris` the elements of the
last ply at the impact are torn off and fly ahead, as the array `joined` says. With `shot` the projectile also
moves along x and y.
"""
import argparse
from pathlib import Path

import h5py
import numpy as np

HISTORY = (
    "time,projectile_x,projectile_y,projectile_z,projectile_vx,projectile_vy,projectile_vz,contact_fx,contact_fy,contact_fz,"
    "kinetic_fabric,kinetic_projectile,internal,hourglass,contact,friction,damping,external,eroded,energy_error,"
    "broken_yarns,eroded_elements,max_displacement,time_step,back_face_deflection"
)
MASS, RADIUS, LENGTH = 2.8e-3, 2.69e-3, 15.7e-3
SPACING, HALF = 0.25e-3, 101.6e-3


def panel(count, plies, symmetry, impact):
    """Reference nodes [n, 3], quads [c, 4] and the ply of each quad, x and y graded from the impact point."""
    half = np.expm1(1.6 * np.linspace(0, 1, count + 1)) / np.expm1(1.6)
    grids = [
        HALF * half
        if axis in symmetry
        else np.concatenate([at - (HALF + at) * half[:0:-1], at + (HALF - at) * half])
        for axis, at in zip("xy", impact)
    ]
    x, y = np.meshgrid(*grids, indexing="ij")
    sheet = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    rows, columns = len(grids[0]) - 1, len(grids[1]) - 1
    i, j = (index.ravel() for index in np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij"))
    first = i * (columns + 1) + j
    quads = np.column_stack([first, first + columns + 1, first + columns + 2, first + 1])
    nodes = np.concatenate([sheet + [0, 0, k * SPACING] for k in range(plies)])
    return (
        nodes,
        np.concatenate([quads + k * len(sheet) for k in range(plies)]),
        np.repeat(np.arange(1, plies + 1), len(quads)),
    )


def cylinder(sectors=32):
    """Surface of a flat cylinder, its nose at the origin, the body towards -z; the faces are quads, those on
    the axis degenerate."""
    angle = np.arange(sectors) * 2 * np.pi / sectors
    profile = [
        (0.0, 0.0),
        (0.9 * RADIUS, 0.0),
        (RADIUS, -0.1 * RADIUS),
        (RADIUS, -LENGTH / 2),
        (RADIUS, -LENGTH),
        (0.0, -LENGTH),
    ]
    points = np.concatenate(
        [np.column_stack([r * np.cos(angle), r * np.sin(angle), np.full(sectors, z)]) for r, z in profile]
    )
    ring, turn = np.arange(sectors), np.roll(np.arange(sectors), -1)
    band = np.column_stack([ring, turn, sectors + turn, sectors + ring])
    return points, np.concatenate([band + k * sectors for k in range(len(profile) - 1)])


def motion(time, perforate):
    """Position and velocity of the nose along z."""
    if perforate:
        lost = 150.0 * np.clip(time / 40e-6, 0, 1)
        return (
            428 * time - 150 / 80e-6 * np.minimum(time, 40e-6) ** 2 - 150 * np.maximum(time - 40e-6, 0),
            428 - lost,
        )
    rate = np.pi / 2 / 140e-6  # turns back at 140 us
    return (
        267 / rate * np.sin(rate * time) * 0.4,
        0.4 * 267 * np.cos(rate * time) + 0.6 * 267 * np.maximum(1 - time / 140e-6, 0) ** 3,
    )


def deflect(reference, time, perforate, impact):
    """Displaced nodes [n, 3] and how far from the impact the pyramid's foot is along x."""
    nose = motion(time, perforate)[0]
    if perforate:  # each ply follows the nose until it breaks, then springs back
        broke = 4.5e-6 * (1 + np.round(reference[:, 2] / SPACING))
        height = motion(np.minimum(time, broke), True)[0] * np.clip(
            1 - np.maximum(time - broke, 0) / 300e-6, 0.2, 1
        )
        height = np.maximum(height - reference[:, 2], 0)
    else:
        height = nose
    reach = 8e-3 + (300 if perforate else 380) * time
    top = 1.5 * RADIUS
    points = reference.copy()
    points[:, 2] += height * np.clip(
        (reach - np.abs(points[:, :2] - impact).sum(axis=1)) / (reach - top), 0, 1
    )
    return points, reach


def torn_off(reference, quads, ply, time, impact):
    """Which elements of the last ply fly ahead: those about the impact, after 10 us."""
    return (
        (np.abs(reference[quads, :2].mean(axis=1) - impact).max(axis=1) < 6e-3)
        & (ply == ply.max())
        & (time > 10e-6)
    )


def eroded(reference, quads, ply, time, perforate, impact):
    """Which elements are gone."""
    middle = reference[quads, :2].mean(axis=1) - impact
    return perforate & (np.hypot(middle[:, 0], middle[:, 1]) < 1.15 * RADIUS) & (time > ply * 4.5e-6)


def cell_arrays(reference, quads, ply, time, reach, impact):
    """Smooth stand-ins for the yarns' stress and strain: greatest along the yarns through the impact."""
    middle = np.abs(reference[quads, :2].mean(axis=1) - impact)
    wave = np.clip(1 - (middle[:, 0] + middle[:, 1]) / (3 * reach), 0, 1)
    level = 2.4e9 * np.exp(-(((time - 50e-6) / 90e-6) ** 2)) * (0.75 + 0.03 * ply)
    fill = level * wave * (0.25 + np.exp(-((middle[:, 1] / 7e-3) ** 2)))
    warp = level * wave * (0.25 + np.exp(-((middle[:, 0] / 7e-3) ** 2)))
    return {"stress_fill": fill, "stress_warp": warp, "strain_fill": fill / 96e9, "strain_warp": warp / 96e9}


def write_results(path, times, count, plies, perforate, symmetry, projectile, impact, shot, debris):
    """results.vtkhdf as weavefront lays it out: fabric and, where there is one, projectile as parts of every
    step."""
    reference, quads, ply = panel(count, plies, symmetry, impact)
    body, faces = cylinder() if projectile else (np.empty((0, 3)), np.empty((0, 4), int))
    parts = 2 if projectile else 1
    n, c = (len(reference), len(body)), (len(quads), len(faces))
    frames = []
    for time in times:
        points, reach = deflect(reference, time, perforate, impact) if projectile else (reference, 1.0)
        start, nose = body + [*impact, 0], body + [*impact, 0] + [
            *np.multiply(shot, time),
            motion(time, perforate)[0],
        ]
        ghost = np.where(eroded(reference, quads, ply, time, perforate, impact), 32, 0).astype("u1")
        arrays = cell_arrays(reference, quads, ply, time, reach, impact)
        if debris:
            torn = torn_off(reference, quads, ply, time, impact)
            points[np.setdiff1d(quads[torn], quads[~torn]), 2] += 40e-3
            arrays["joined"] = np.where(torn | (ghost > 0), 0, 1).astype("i1")
        cells = {name: np.concatenate([value, np.zeros(c[1], value.dtype)]) for name, value in arrays.items()}
        moved = np.concatenate([points - reference, nose - start])
        frames.append(
            (np.concatenate([points, nose]), moved, np.concatenate([ghost, np.zeros(c[1], "u1")]), cells)
        )
    with h5py.File(path, "w") as file:
        scene = f"title: {plies} plies of Kevlar 129 at {428 if perforate else 267} m/s\ntarget:\n  symmetry: [{', '.join(symmetry)}]\n"
        file["scene"] = np.frombuffer(scene.encode(), "u1")
        root = file.create_group("VTKHDF")
        root.attrs["Version"], root.attrs["Type"] = (2, 0), np.bytes_("UnstructuredGrid")
        root["NumberOfPoints"], root["NumberOfCells"], root["NumberOfConnectivityIds"] = (
            n[:parts],
            c[:parts],
            (4 * c[0], 4 * c[1])[:parts],
        )
        root["Connectivity"] = np.concatenate([quads.ravel(), faces.ravel()])
        root["Offsets"] = np.concatenate([4 * np.arange(cells + 1) for cells in c[:parts]])
        root["Types"] = np.full(sum(c), 9, "u1")
        root["Points"] = np.concatenate([frame[0] for frame in frames])
        root["PointData/displacement"] = np.concatenate([frame[1] for frame in frames])
        root["CellData/ply"] = np.concatenate([ply, np.zeros(c[1], int)])
        root["CellData/vtkGhostType"] = np.concatenate([frame[2] for frame in frames])
        for name in frames[0][3]:
            root[f"CellData/{name}"] = np.concatenate([frame[3][name] for frame in frames])
        write_steps(root, times, sum(n), sum(c))


def write_steps(root, times, n, c):
    """The group Steps, with one step more in the arrays than NSteps says, as after a kill while a frame was
    being written."""
    steps, k = root.create_group("Steps"), np.arange(len(times) + 1)
    steps.attrs["NSteps"] = len(times)
    steps["Values"] = np.append(times, times[-1] + 1e-6)
    steps["PointOffsets"], steps["PointDataOffsets/displacement"] = k * n, k * n
    for name in root["CellData"]:
        steps[f"CellDataOffsets/{name}"] = 0 * k if name == "ply" else k * c


def write_history(path, end, perforate, projectile, impact, shot):
    """history.csv in the order of its columns; nothing happens without a projectile."""
    time = np.linspace(0, end, 401)
    z, v = motion(time, perforate) if projectile else (0 * time, 0 * time)
    initial = 0.5 * MASS * v[0] ** 2
    kinetic = 0.5 * MASS * v**2
    lost = initial - kinetic
    zero = np.zeros_like(time)
    broken = np.floor(np.clip(time / 4.5e-6, 0, 8)) * 46 if perforate else zero
    share = {
        "fabric": 0.45,
        "internal": 0.40,
        "hourglass": 0.012,
        "contact": 0.11,
        "friction": 0.02,
        "damping": 0.008,
    }
    (x, y), (vx, vy) = impact, shot
    columns = [
        time,
        x + vx * time,
        y + vy * time,
        z,
        vx + zero,
        vy + zero,
        v,
        zero,
        zero,
        np.gradient(v, time) * MASS,
        share["fabric"] * lost,
        kinetic,
        share["internal"] * lost,
        share["hourglass"] * lost,
        share["contact"] * lost,
        share["friction"] * lost,
        share["damping"] * lost,
        zero,
        zero,
        projectile * 2e-4 * np.sin(time / end * 6),
        broken,
        broken / 2,
        z,
        1e-7 + zero,
        0.9 * z,
    ]
    np.savetxt(path, np.column_stack(columns), delimiter=",", header=HISTORY, comments="", fmt="%.17g")


def write_run(
    folder,
    count=10,
    plies=8,
    perforate=False,
    frames=9,
    end=200e-6,
    symmetry="xy",
    projectile=True,
    impact=(0, 0),
    shot=(0, 0),
    debris=False,
):
    """The whole folder."""
    folder.mkdir(parents=True, exist_ok=True)
    times = np.linspace(0, end, frames)
    write_results(
        folder / "results.vtkhdf", times, count, plies, perforate, symmetry, projectile, impact, shot, debris
    )
    write_history(folder / "history.csv", end, perforate, projectile, impact, shot)


if __name__ == "__main__":
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("folder", type=Path)
    options.add_argument("--count", type=int, default=10, help="elements along an edge of the quarter")
    options.add_argument("--symmetry", default="xy", help="xy, x, y or nothing")
    options.add_argument("--perforate", action="store_true")
    chosen = options.parse_args()
    write_run(chosen.folder, chosen.count, perforate=chosen.perforate, frames=41, symmetry=chosen.symmetry)
