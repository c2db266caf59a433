"""Plies and projectiles of one frame as coloured faces in space, with one quarter taken out at the impact."""
import numpy as np
from matplotlib.colors import to_rgb

from .faces import Faces
from .geometry import cut, images, mirrored, spacing
from .style import FIELD

GREY = np.array(to_rgb("#a9adb2"))
BEHIND = 0.06  # of its width by which the projectile is drawn behind: flat elements cut into what is round
PALE = 0.3  # of its colour that debris keeps, the rest is white
EDGE = 0.55  # thickness of a ply in a cut, over the distance between plies
FINEST = 4  # pixels from ply to ply, from which each has an edge of its own
DARK = 0.42  # of its colour that the cut edge of a ply keeps


class Space:
    """Fabric within `window` (m) of the impact along x and y, without the `opening`, and the projectiles."""

    def __init__(self, run, fabric, window, view, opening, debris):
        self.results, self.fabric, self.window, self.view, self.opening = (
            run.results,
            fabric,
            window,
            view,
            opening,
        )
        self.shows_debris = debris
        self.spacing = 1e3 * spacing(self.results.reference, fabric.quads, self.results.ply)
        self.edge = EDGE * self.spacing  # thickness of a ply in a cut
        self.centres = self.results.reference[fabric.quads, :2].mean(axis=1)
        self.impact = np.array([run.impact.x, run.impact.y])

    def draw_with(self, pixel):
        """Says how large a pixel is in mm: plies too thin for a line each get cut edges that touch."""
        if self.spacing * np.cos(np.radians(self.view.elevation)) < FINEST * pixel:
            self.edge = self.spacing

    def pieces(self, step, shown):
        """Points in mm of each mirror image, and its elements among `shown` in the window, in part at
        least."""
        points = self.results.points(step) * 1e3
        for sign in images(self.results.symmetry):
            image, near = (
                mirrored(points, sign),
                np.abs(self.centres * sign - self.impact).max(axis=1) <= self.window,
            )
            cells = np.flatnonzero(shown & near)
            if self.opening:
                sides = self.opening.sides(image[self.fabric.quads[cells]])
                cells = cells[sides.min(axis=(1, 2)) < -1e-9 * np.abs(sides).max(initial=1.0)]
            yield image, cells

    def plies(self, step, values, norm):
        """The fabric's faces in mm, coloured by the values [c] of its elements."""
        colours = FIELD(norm(values))[:, :3]
        groups = self._plies(step, self.fabric.joined(step), colours)
        if self.shows_debris and self.results.knows_debris:
            groups += self._plies(step, self.fabric.debris(step), 1 - PALE * (1 - colours))
        return Faces.join(groups)

    def _plies(self, step, shown, colours):
        groups = []
        for points, cells in self.pieces(step, shown):
            quads = self.fabric.quads[cells]
            corners = points[quads]
            lit = self.view.lit(corners, colours[cells], 0.5)
            if self.opening is None:
                groups.append(Faces.whole(corners, lit))
                continue
            reaching = np.all(self.opening.sides(corners).max(axis=1) > 0, axis=1)
            groups.append(Faces(corners, lit, reaching))
            groups += [
                self._edges(points, quads, colours[cells], normal, axis)
                for normal, axis in self.opening.planes()
            ]
        return groups

    def _edges(self, points, quads, colours, normal, axis):
        """The cut edges of the plies on one plane of the open quarter, as dark bands."""
        segments, cells = cut(points, quads, normal, (self.opening.x, self.opening.y))
        out = self.opening.sides(segments)[..., axis]  # along the plane, from the corner of the quarter
        segments, cells, out = (part[out.max(axis=1, initial=0.0) > 0] for part in (segments, cells, out))
        past = np.maximum(-out, 0) / np.maximum(np.ptp(out, axis=1), 1e-300)[:, None]
        segments = segments + past[..., None] * (segments[:, ::-1] - segments)
        half = np.array([0.0, 0.0, self.edge / 2])
        return Faces.whole(
            np.concatenate([segments - half, segments[:, ::-1] + half], axis=1), DARK * colours[cells]
        )

    def projectiles(self, step, top):
        """The faces of the projectiles in mm, without those that are wholly above `top` in mm."""
        faces = Faces.whole(np.empty((0, 4, 3)), np.empty((0, 3)))
        for surface in self.results.projectiles(step):
            if 1e3 * surface.points[:, 2].min() > top:
                continue
            corners = surface.points[surface.quads] * 1e3
            behind = BEHIND * np.ptp(corners[..., 0]) * self.view.axes()[2]
            faces = Faces.join([faces, Faces.whole(corners - behind, self.view.lit(corners, GREY, 0.85))])
        return faces

    def faces(self, step, values, norm):
        """Plies and projectiles."""
        return Faces.join([self.plies(step, values, norm), self.projectiles(step, self.top(step))])

    def top(self, step):
        """Up to where projectiles are drawn, in mm: a quarter of the window above the fabric."""
        heights = [
            points[self.fabric.quads[cells], 2].max(initial=0.0)
            for points, cells in self.pieces(step, self.fabric.joined(step))
        ]
        return max(heights) + 0.25e3 * self.window

    def extent(self, step):
        """Lowest and highest coordinates of joined fabric and projectiles [2, 2]; None without fabric."""
        corners = [
            points[self.fabric.quads[cells]].reshape(-1, 3)
            for points, cells in self.pieces(step, self.fabric.joined(step))
        ]
        if not any(map(len, corners)):
            return None
        corners.append(self.projectiles(step, self.top(step)).corners.reshape(-1, 3))
        seen = self.view.project(np.concatenate(corners))[:, :2]
        return np.array([seen.min(axis=0), seen.max(axis=0)])
