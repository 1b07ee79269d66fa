#!/usr/bin/env python3
"""Renders a scene of scenes.py with Mitsuba 3 (pip install mitsuba pyoidn), once for each line of
JSON on standard input: {"spp", "seed", "picture": file or "", "denoise"}.

usage: mitsuba_worker.py SCENE.json [VARIANT]

Prints "ready", then for each line the seconds of the render, with those of Open Image Denoise if it
denoises. Its kernels are compiled before.
"""

import json
import pathlib
import sys
import time

import mitsuba as mi
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from rectangles import square_to  # noqa: E402  (of tests/bench)

scene_file = pathlib.Path(sys.argv[1])
description = json.loads(scene_file.read_text())
mi.set_variant(sys.argv[2] if len(sys.argv) > 2 else "llvm_ad_rgb")
import drjit as dr  # noqa: E402  (of the variant)

Transform = mi.ScalarTransform4f
SAMPLES_OF_A_PASS = 128  # bounds the memory


def rgb(value):
    return {"type": "rgb", "value": value}


def color(value):
    if not isinstance(value, str):
        return rgb(value)
    texture = description["textures"][value]
    return {"type": "bitmap", "filename": str(scene_file.parent / texture["file"]),
            "to_uv": Transform().scale([*texture["scale"], 1])}


def material(name):
    values = description["materials"][name]
    if values["type"] == "dielectric":
        return {"type": "dielectric", "int_ior": values["ior"], "ext_ior": 1.0}
    return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": color(values["color"])}}


def rectangle(vertices):
    return {"type": "rectangle", "to_world": Transform(square_to(vertices))}


def translated():
    camera, film = description["camera"], description["film"]
    # max_depth counts the edges of a path: its scattering events and the last ray.
    path = {"type": "path", "max_depth": description["render"]["max_bounces"] + 1}
    result = {
        "type": "scene",
        "sensor": {
            "type": "perspective", "fov": camera["fov"], "fov_axis": "y",
            "near_clip": 1e-3,
            "to_world": Transform().look_at(origin=camera["position"], target=camera["target"],
                                            up=[0, 1, 0]),
            "film": {"type": "hdrfilm", "width": film["width"], "height": film["height"],
                     "pixel_format": "rgb", "component_format": "float32",
                     "rfilter": {"type": "box"}},
            "sampler": {"type": "independent"}},
        "integrator": path,
    }
    for number, shape in enumerate(description["shapes"]):
        result[f"shape{number}"] = {
            "type": "obj", "filename": str(scene_file.parent / shape["file"]),
            "face_normals": shape.get("normals") != "smooth", "flip_tex_coords": False,
            "bsdf": material(shape["material"])}
    for number, lamp in enumerate(description["lights"]):
        result[f"lamp{number}"] = {
            **rectangle(lamp["vertices"]), "bsdf": {"type": "diffuse", "reflectance": rgb(0)},
            "emitter": {"type": "area", "radiance": rgb(lamp["radiance"])}}
    if description["background"]:
        result["background"] = {"type": "constant", "radiance": rgb(description["background"])}
    return result


scene = mi.load_dict(translated())
features = mi.load_dict({"type": "aov", "aovs": "albedo:albedo,normal:sh_normal",
                         "path": {"type": "path", "max_depth": 1}})


def pixels(image):
    return numpy.array(image, dtype=numpy.float32)


def samples(count, seed):
    total, done, number = 0, 0, 0
    while done < count:
        step = min(SAMPLES_OF_A_PASS, count - done)
        image = mi.render(scene, spp=step, seed=1000 * seed + number)
        dr.eval(image)
        total, done, number = total + step * pixels(image), done + step, number + 1
    return total / count


def denoised(color, seed):
    import pyoidn
    layers = pixels(mi.render(scene, integrator=features, spp=32, seed=seed))
    return pyoidn.denoise(color, albedo=layers[..., -6:-3].copy(), normal=layers[..., -3:].copy(),
                          hdr=True)


def render(request):
    start = time.perf_counter()
    image = samples(request["spp"], request["seed"])
    if request.get("denoise"):
        image = denoised(image, request["seed"])
    seconds = time.perf_counter() - start
    if request["picture"]:
        mi.Bitmap(image).write(request["picture"])
    return seconds


render({"spp": 1, "seed": 0, "picture": "", "denoise": True})
print("ready", flush=True)
for line in sys.stdin:
    print(json.dumps({"seconds": render(json.loads(line))}), flush=True)
