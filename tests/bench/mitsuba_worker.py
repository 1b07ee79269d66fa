#!/usr/bin/env python3
"""Renders a scene of Calotype's with Mitsuba 3, once for each line on standard input.

usage: mitsuba_worker.py VARIANT SCENE.json SPP

Reads of Calotype's scenes what `compare` writes: a pinhole camera, diffuse materials on meshes and
quads, and quads that shine from their front. Prints "ready", then for each line read the seconds
that one picture took. A line that names a file also writes the picture there (PFM).
"""
import json
import sys
import time
from pathlib import Path

import mitsuba as mi
from rectangles import square_to

variant, scene_file, samples = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3])
mi.set_variant(variant)
import drjit as dr  # noqa: E402  (of the variant)

Transform = mi.ScalarTransform4f


def rgb(value):
    return {"type": "rgb", "value": value}


def diffuse(reflectance):
    return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": rgb(reflectance)}}


def rectangle(vertices):
    return {"type": "rectangle", "to_world": Transform(square_to(vertices))}


def mesh(shape):
    return {"type": "obj", "filename": str(scene_file.parent / shape["file"]),
            "face_normals": True,
            "to_world": Transform().scale(shape.get("transform", {}).get("scale", 1))}


def translated(scene):
    camera, film = scene["camera"], scene["film"]
    result = {
        "type": "scene",
        # max_depth counts the edges of a path: its scattering events and the last ray.
        "integrator": {"type": "path", "max_depth": scene["render"]["max_bounces"] + 1,
                       "rr_depth": 1000},
        "sensor": {
            "type": "perspective",
            "fov": camera["fov"],
            "fov_axis": "y",
            "to_world": Transform().look_at(origin=camera["position"], target=camera["target"],
                                            up=[0, 1, 0]),
            "film": {"type": "hdrfilm", "width": film["width"], "height": film["height"],
                     "pixel_format": "rgb", "component_format": "float32",
                     "rfilter": {"type": "box"}},
            "sampler": {"type": "independent", "sample_count": samples},
        },
    }
    for number, shape in enumerate(scene["shapes"]):
        translation = mesh(shape) if shape["type"] == "mesh" else rectangle(shape["vertices"])
        color = scene["materials"][shape["material"]]["color"]
        result[f"shape{number}"] = {**translation, "bsdf": diffuse(color)}
    for number, light in enumerate(scene["lights"]):
        result[f"light{number}"] = {
            **rectangle(light["vertices"]), "bsdf": diffuse(0.0),
            "emitter": {"type": "area", "radiance": rgb(light["radiance"])}}
    return result


scene = mi.load_dict(translated(json.loads(scene_file.read_text())))


def render(seed):
    start = time.perf_counter()
    image = mi.render(scene, spp=samples, seed=seed)
    dr.eval(image)
    dr.sync_thread()
    return image, time.perf_counter() - start


render(0)  # compiles
print("ready", flush=True)
for seed, line in enumerate(sys.stdin, start=1):
    image, seconds = render(seed)
    if line.strip():
        mi.Bitmap(image).write(line.strip())
    print(seconds, flush=True)
