#!/usr/bin/env python3
"""Writes the meshes and maps of scenes/*.json beside this file; needs Python 3.9, nothing else.

    python3 assets/generate.py            write every file
    python3 assets/generate.py hare       write some
    python3 assets/generate.py --check    compare the committed files with what would be written

The files are the same on every machine: random numbers are seeded, coordinates rounded. Of PNG
files the pixels are: zlib's versions compress them differently. (Everything takes a minute or two.)
"""

import pathlib
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout

from generator import backdrop, camera, cloth, cushion, cushion_maps, damask  # noqa: E402
from generator import furniture, hare, leaf_maps, linen, monstera_maps, ornament  # noqa: E402
from generator import parquet, plant, room, textured_cube, wood  # noqa: E402

MESHES = {
    "backdrop": backdrop.backdrop,
    "chair": furniture.chair,
    "curtain": cloth.curtain,
    "cushion": cushion.cushion,
    "hare": hare.hare,
    "monstera": plant.monstera,
    "picture_frame": room.picture_frame,
    "rubber_plant": plant.rubber_plant,
    "table": furniture.table,
    "table_cloth": cloth.table_cloth,
    "textured_cube": textured_cube.textured_cube,
    "view_camera": camera.view_camera,
    "walls": room.walls,
    "wainscot": room.wainscot,
    "window": room.window,
}
MAPS = {
    "cushion_color": cushion_maps.color,
    "cushion_heights": cushion_maps.heights,
    "damask_color": damask.color,
    "damask_normals": damask.normals,
    "leaf_color": leaf_maps.color,
    "leaf_normals": leaf_maps.normals,
    "linen_normals": linen.normals,
    "monstera_color": monstera_maps.color,
    "monstera_normals": monstera_maps.normals,
    "ornament_normals": ornament.normals,
    "parquet_color": parquet.color,
    "parquet_normals": parquet.normals,
    "parquet_roughness": parquet.roughness,
    "walnut_color": wood.walnut,
}
FOLDER = pathlib.Path(__file__).resolve().parent


def main(arguments):
    """Returns the exit code: 1 if a name is unknown or a committed file differs."""
    checking = "--check" in arguments
    known = [*MESHES, *MAPS]
    names = [a for a in arguments if a != "--check"] or known
    unknown = [name for name in names if name not in known]
    if unknown:
        print(f"Nothing is called {unknown[0]}; there are {', '.join(known)}.", file=sys.stderr)
        return 1
    differing = []
    for name in names:
        path, same = (_mesh if name in MESHES else _map)(name, checking)
        if not same:
            differing.append(path.name)
    if differing:
        listed = ", ".join(differing)
        print(f"Not what generate.py writes: {listed}; run it again.", file=sys.stderr)
    return 1 if differing else 0


def _mesh(name, checking):
    """The file's path, and whether it holds what it should: always, unless `checking`."""
    mesh, path = MESHES[name](), FOLDER / f"{name}.obj"
    data = mesh.text().encode("ascii")
    if checking:
        return path, path.is_file() and path.read_bytes() == data
    path.write_bytes(data)
    print(f"{path.name}: {mesh.triangles} triangles, {len(data) / 1e6:.2f} MB")
    return path, True


def _map(name, checking):
    """The same for a picture."""
    image, path = MAPS[name](), FOLDER / f"{name}.png"
    if checking:
        return path, path.is_file() and image.is_in(path.read_bytes())
    data = image.encoded()
    path.write_bytes(data)
    print(f"{path.name}: {image.width} x {len(image.rows)}, {len(data) / 1e6:.2f} MB")
    return path, True


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
