#!/usr/bin/env python3
"""Checks scenes/*.json against scenes/scene.schema.json, and that the schema refuses bad scenes.

Usage: schema_check.py SCENES_FOLDER. Needs python3-jsonschema; exits 77 where it is missing.
"""

import copy
import json
import pathlib
import re
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)

STRING_OR_COMMENT = re.compile(r'("(?:\\.|[^"\\])*")|//[^\n]*|/\*.*?\*/', re.DOTALL)

# What is set in a valid scene, by path; the schema must refuse the result.
BROKEN = [
    (["camrea"], {}),
    (["camera", "fov"], 180),
    (["camera", "up"], [0, 0, 0]),
    (["camera", "height"], 2),
    (["camera"], {"type": "orthographic"}),
    (["camera"], {"type": "orthographic", "height": 2, "fov": 40}),
    (["camera"], {"type": "orthographic", "height": 0}),
    (["camera"], {"lens_radius": 0.1}),
    (["camera", "lens_radius"], -0.1),
    (["camera", "focus_distance"], 0),
    (["camera", "matrix"], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]),
    (["film", "width"], 0),
    (["film", "filter"], "bx"),
    (["render", "spp"], 0.5),
    (["background"], -1),
    (["materials", "wall"], {"type": "difuse", "color": 1}),
    (["materials", "wall", "color"], 1.5),
    (["materials", "wall", "color"], "#12345"),
    (["materials", "wall", "roughness"], 0.5),
    (["materials", "gold"], {"type": "metal", "color": 1}),
    (["materials", "gold", "roughness"], 1.5),
    (["materials", "gold", "roughness"], "#102030"),
    (["materials", "gold", "masking"], "smth"),
    (["materials", "gold", "specular"], 0.5),
    (["materials", "gold", "normal_map"], ""),
    (["materials", "wood", "specular"], -0.1),
    (["materials", "wood", "specular"], [0.04, 0.04, 0.04]),
    (["materials", "paint", "ks"], 1.1),
    (["materials", "paint", "ks"], "oak"),
    (["materials", "paint", "exponent"], 10000001),
    (["materials", "paint", "displacement"], {"texture": "oak"}),
    (["materials", "paint", "displacement"], {"texture": "oak", "scale": 1, "subdivide": 13}),
    (["materials", "paint", "displacement"], {"texture": "oak", "scale": 1, "subdivide": 0.5}),
    (["materials", "glass", "ior"], 0),
    (["materials", "glass", "color"], "oak"),
    (["materials", "glass", "emission"], 1),
    (["materials", "wall", "emission"], "oak"),
    (["shapes", 0, "radius"], 0),
    (["shapes", 0, "raduis"], 1),
    (["shapes", 0, "transform"], {"scale": 0}),
    (["shapes", 0, "transform"], {"scale": 1, "matrix": [1] * 16}),
    (["shapes", 1, "vertices"], [[0, 0, 0]]),
    (["shapes", 1, "uvs"], [[0, 0], [1, 0], [1, 1]]),
    (["shapes", 1, "uvs"], [[0, 0], [1, 0], [1, 1], [0, 1, 0]]),
    (["shapes", 1, "uvs"], [[0, 0], [1, 0], [1, 1], [0, 1.1e9]]),
    (["shapes", 1, "uvs"], [[0, 0], [1, 0], [1, 1], [-1.1e9, 0]]),
    (["shapes", 0, "uvs"], [[0, 0]]),
    (["textures", "tiles", "scale"], [1, 0]),
    (["textures", "tiles", "scale"], [1, 1.1e9]),
    (["lights", 0, "uvs"], [[0, 0]]),
    (["lights", 0, "power"], 1),
    (["lights", 0, "type"], "sphere"),
]

# What the schema must accept in the same place.
ACCEPTED = [
    (["camera"], {"type": "orthographic", "height": 2}),
    (["camera"], {"type": "orthographic", "height": 2, "lens_radius": 0.1, "target": [1, 0, 0]}),
    (["camera"], {"lens_radius": 0.1, "focus_distance": 3}),
    (["camera"], {"lens_radius": 0}),
    (["materials", "wood", "specular"], 0.08),
    (["materials", "gold", "masking"], "schlick"),
    (["textures", "tiles", "scale"], [1e9, 1e-9]),
    (["shapes", 1, "uvs"], [[0, 0], [1, 0], [1e9, 1], [0, -1e9]]),
]

VALID = {
    "$schema": "scene.schema.json",
    "camera": {"position": [0, 1, 4], "target": [0, 1, 0], "fov": 40, "lens_radius": 0.1},
    "film": {"width": 64, "height": 64, "filter": "blackman-harris"},
    "render": {"spp": 4},
    "textures": {
        "oak": {"type": "image", "file": "oak.png", "wrap": "clamp"},
        "tiles": {"type": "checker", "colors": [0.8, "#203040"], "scale": [8, 8]},
    },
    "materials": {
        "wall": {"type": "diffuse", "color": 0.7},
        "gold": {"type": "metal", "color": [1, 0.8, 0.3], "roughness": 0.1, "normal_map": "oak"},
        "wood": {"type": "nonmetal", "color": "oak", "roughness": "oak", "specular": "oak",
                 "masking": "smith", "alpha": False},
        "paint": {"type": "blinn_phong", "color": 1, "kd": 0.9, "ks": 0.02, "exponent": 1e7,
                  "normalize": True,
                  "displacement": {"texture": "tiles", "scale": -0.1, "subdivide": 12}},
        "glass": {"type": "dielectric", "ior": 1.5, "exterior_ior": 1.33, "color": "#ffeedd"},
    },
    "shapes": [
        {"type": "sphere", "radius": 1, "material": "wall"},
        {"type": "quad", "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
         "uvs": [[0, 0], [2, 0], [2, 2], [0, -2]], "material": "wall",
         "transform": {"rotate": [0, 90, 0]}},
        {"type": "mesh", "file": "a.obj", "materials": {"seat": "wood", "*": "wall"},
         "displacement": {"texture": "oak", "scale": 0.01, "mid": 0, "subdivide": 4}},
    ],
    "lights": [{"type": "disk", "radius": 1, "radiance": 5}],
}


def without_comments(text):
    return STRING_OR_COMMENT.sub(lambda match: match.group(1) or " ", text)


def with_value(scene, path, value):
    changed = copy.deepcopy(scene)
    place = changed
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    return changed


def main():
    folder = pathlib.Path(sys.argv[1])
    schema = json.loads((folder / "scene.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    scenes = [(path.name, json.loads(without_comments(path.read_text())))
              for path in sorted(folder.glob("*.json")) if path.name != "scene.schema.json"]
    failures = [f"no scenes in {folder}"] if not scenes else []
    for name, scene in scenes + [("the valid scene", VALID)]:
        for error in validator.iter_errors(scene):
            failures.append(f"{name}: {error.json_path}: {error.message}")
    for path, value in ACCEPTED:
        if not validator.is_valid(with_value(VALID, path, value)):
            failures.append(f"refused {value} at {path}")
    for path, value in BROKEN:
        if validator.is_valid(with_value(VALID, path, value)):
            failures.append(f"accepted {value} at {path}")
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
