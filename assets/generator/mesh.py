"""Surfaces, and the meshes they are gathered into and written from as Wavefront OBJ."""

from generator import vectors

POSITION_DECIMALS = 5  # 0.01 mm
NORMAL_DECIMALS = 3
UV_DECIMALS = 4


class Surface:
    """Points, and polygons that run counter-clockwise as seen from outside.

    `normals` has one unit vector per point. Without it, smooth surfaces get area-weighted means,
    which are right on dense grids, and others stay flat. `uvs` has a texture coordinate per point;
    points that share a position are one in the file, so a texture's seam does not tear a surface.
    """

    def __init__(self, points, faces, normals=None, smooth=True, uvs=None):
        self.points = points
        self.faces = faces
        self.normals = normals
        self.smooth = smooth
        self.uvs = uvs

    def placed(self, frame):
        """The same surface in the outer coordinates of `frame`."""
        points = [frame.point(p) for p in self.points]
        normals = self.normals and [frame.direction(n) for n in self.normals]
        return Surface(points, self.faces, normals, self.smooth, self.uvs)


class Mesh:
    """Surfaces by material.

    Without `normals` the file is half the size; the scene then asks for `"normals": "smooth"`.
    """

    def __init__(self, name, normals=True):
        self._with_normals = normals
        self._lines = [f"# {name}, written by generate.py."]
        self._positions = 0
        self._uvs = 0
        self._normals = 0
        self._material = None
        self.triangles = 0

    def add(self, material, surface, frame=None):
        """Appends `surface`, placed by `frame`, rounded and rid of what has no area."""
        if frame:
            surface = surface.placed(frame)
        points, position = _distinct(surface.points, POSITION_DECIMALS)
        faces = [_without_repeats([position[i] for i in face]) for face in surface.faces]
        kept = [i for i, face in enumerate(faces) if len(face) >= 3]
        lines = self._lines
        if material != self._material:
            lines.append(f"usemtl {material}")
            self._material = material
        lines += ["v " + _numbers(p, POSITION_DECIMALS) for p in points]
        uvs, uv, normals = [], None, []
        if surface.uvs:
            uvs, uv = _distinct(surface.uvs, UV_DECIMALS)
            lines += ["vt " + _numbers(t, UV_DECIMALS) for t in uvs]
        if self._with_normals and (surface.normals or surface.smooth):
            normals = surface.normals or _area_weighted(points, position, faces)
            lines += ["vn " + _numbers(n, NORMAL_DECIMALS) for n in normals]
        for i in kept:
            lines.append("f " + self._corners(surface.faces[i], position, uv, bool(normals)))
        self._positions += len(points)
        self._uvs += len(uvs)
        self._normals += len(normals)
        self.triangles += sum(len(faces[i]) - 2 for i in kept)

    def _corners(self, face, position, uv, with_normals):
        """The corners in OBJ's notation, without those that repeat a position."""
        texts = []
        for k, corner in enumerate(face):
            if position[corner] == position[face[k - 1]]:
                continue
            text = str(position[corner] + 1 + self._positions)
            if uv or with_normals:
                text += f"/{uv[corner] + 1 + self._uvs}" if uv else "/"
            if with_normals:
                text += f"/{corner + 1 + self._normals}"
            texts.append(text)
        return " ".join(texts)

    def text(self):
        return "\n".join(self._lines) + "\n"


def _numbers(values, decimals):
    return " ".join(f"{round(v, decimals) + 0.0:.{decimals}f}" for v in values)


def _distinct(tuples, decimals):
    """The distinct tuples as rounded, and for each given one its index among them."""
    distinct, index = {}, []
    for numbers in tuples:
        key = tuple(round(v, decimals) + 0.0 for v in numbers)
        index.append(distinct.setdefault(key, len(distinct)))
    return list(distinct), index


def _without_repeats(face):
    return [corner for k, corner in enumerate(face) if corner != face[k - 1]]


def _area_weighted(points, index, faces):
    """One normal per given point: the mean over the faces about its position."""
    sums = [(0.0, 0.0, 0.0)] * len(points)
    for face in faces:
        for k in range(1, len(face) - 1):
            a, b, c = (points[face[i]] for i in (0, k, k + 1))
            normal = vectors.cross(vectors.subtract(b, a), vectors.subtract(c, a))
            for corner in (face[0], face[k], face[k + 1]):
                sums[corner] = vectors.add(sums[corner], normal)
    units = [vectors.normalize(s) if any(s) else (0.0, 1.0, 0.0) for s in sums]
    return [units[i] for i in index]
