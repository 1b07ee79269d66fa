#!/usr/bin/env python3
"""Writes the meshes of scenes/atelier.json beside this file; needs Python 3.9, nothing else.

    python3 assets/generate.py            write every mesh
    python3 assets/generate.py hare       write some
    python3 assets/generate.py --check    compare the committed files with what would be written

The meshes are the same on every machine: random numbers are seeded, coordinates rounded.
"""

import pathlib
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout

from generator import camera, cloth, furniture, hare, plant, room  # noqa: E402

MESHES = {
    "chair": furniture.chair,
    "curtain": cloth.curtain,
    "floorboards": room.floorboards,
    "hare": hare.hare,
    "picture_frame": room.picture_frame,
    "potted_plant": plant.potted_plant,
    "table": furniture.table,
    "table_cloth": cloth.table_cloth,
    "view_camera": camera.view_camera,
    "walls": room.walls,
    "wainscot": room.wainscot,
    "window": room.window,
}
FOLDER = pathlib.Path(__file__).resolve().parent


def main(arguments):
    """Returns the exit code: 1 if a name is unknown or a committed file differs."""
    checking = "--check" in arguments
    names = [a for a in arguments if a != "--check"] or list(MESHES)
    unknown = [name for name in names if name not in MESHES]
    if unknown:
        print(f"No mesh is called {unknown[0]}; there are {', '.join(MESHES)}.", file=sys.stderr)
        return 1
    differing = []
    for name in names:
        mesh = MESHES[name]()
        path = FOLDER / f"{name}.obj"
        data = mesh.text().encode("ascii")
        if not checking:
            path.write_bytes(data)
            print(f"{path.name}: {mesh.triangles} triangles, {len(data) / 1e6:.2f} MB")
        elif not path.is_file() or path.read_bytes() != data:
            differing.append(path.name)
    if differing:
        listed = ", ".join(differing)
        print(f"Not what generate.py writes: {listed}; run it again.", file=sys.stderr)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
