#!/usr/bin/env python3
"""Renders the generated bench scene with Mitsuba 3, once for each line on standard input.

usage: mitsuba_worker.py VARIANT MESH.obj SPP

The scene is that of host/cli/bench_scene.cpp; its mesh comes from bench_mesh. Prints "ready", then
for each line read the seconds that one picture took. A line that names a file also writes the
picture there (PFM).
"""
import sys
import time

import mitsuba as mi

variant, mesh, samples = sys.argv[1], sys.argv[2], int(sys.argv[3])
mi.set_variant(variant)
import drjit as dr  # noqa: E402  (of the variant)

Transform = mi.ScalarTransform4f


def diffuse(reflectance):
    return {"type": "diffuse", "reflectance": {"type": "rgb", "value": reflectance}}


scene = mi.load_dict({
    "type": "scene",
    # max_depth counts the edges of a path: three scattering events and the last ray.
    "integrator": {"type": "path", "max_depth": 4, "rr_depth": 1000},
    "sensor": {
        "type": "perspective",
        "fov": 48.4555,
        "to_world": Transform().look_at(origin=[0, 0, 3.2], target=[0, 0, 0], up=[0, 1, 0]),
        "film": {"type": "hdrfilm", "width": 512, "height": 512, "pixel_format": "rgb",
                 "component_format": "float32", "rfilter": {"type": "box"}},
        "sampler": {"type": "independent", "sample_count": samples},
    },
    "balls": {"type": "obj", "filename": mesh, "face_normals": True,
              "bsdf": {"type": "twosided", "bsdf": diffuse(0.7)}},
    "floor": {"type": "rectangle",
              "to_world": Transform().translate([0, -0.9, 0]).rotate([1, 0, 0], -90).scale(3),
              "bsdf": {"type": "twosided", "bsdf": diffuse(0.5)}},
    "lamp": {"type": "rectangle",
             "to_world": Transform().translate([0, 2.5, 1.0]).rotate([1, 0, 0], 90).scale(0.8),
             "bsdf": diffuse(0.0),
             "emitter": {"type": "area", "radiance": {"type": "rgb", "value": 10.0}}},
})


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
