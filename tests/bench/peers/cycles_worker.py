#!/usr/bin/env python3
"""Renders a scene of scenes.py with Cycles (pip install bpy), once for each line of JSON on
standard input: {"spp", "seed", "picture": file or "", "denoise", "adaptive", "light_tree"}.

usage: cycles_worker.py SCENE.json

Prints "ready", then for each line the seconds of the render, denoising included. Scene and BVH are
kept from one to the next.
"""

import array
import json
import math
import os
import pathlib
import sys
import time

answers = os.fdopen(os.dup(1), "w")  # Blender writes its progress to standard output
os.dup2(os.open(os.devnull, os.O_WRONLY), 1)

import bpy  # noqa: E402
from mathutils import Matrix, Vector  # noqa: E402

# Blender 5.0.1 shows lamps of this kind 1.7624 % too bright (measured on a visible lamp).
LAMP_SCALE = 1 / 1.017624

scene_file = pathlib.Path(sys.argv[1])
description = json.loads(scene_file.read_text())


def triple(value):
    return (value,) * 3 if isinstance(value, (int, float)) else tuple(value)


def nodes_of(owner):
    owner.use_nodes = True
    owner.node_tree.nodes.clear()
    return owner.node_tree.nodes, owner.node_tree.links


def image_node(nodes, links, texture):
    node = nodes.new("ShaderNodeTexImage")
    node.image = bpy.data.images.load(str(scene_file.parent / texture["file"]))
    mapping = nodes.new("ShaderNodeMapping")
    mapping.inputs["Scale"].default_value = (*texture["scale"], 1)
    coordinates = nodes.new("ShaderNodeTexCoord")
    links.new(coordinates.outputs["UV"], mapping.inputs["Vector"])
    links.new(mapping.outputs["Vector"], node.inputs["Vector"])
    return node


def material(name):
    values = description["materials"][name]
    result = bpy.data.materials.new(name)
    nodes, links = nodes_of(result)
    output = nodes.new("ShaderNodeOutputMaterial")
    if values["type"] == "dielectric":
        shader = nodes.new("ShaderNodeBsdfGlass")
        shader.inputs["Roughness"].default_value = 0
        shader.inputs["IOR"].default_value = values["ior"]
    else:
        shader = nodes.new("ShaderNodeBsdfDiffuse")
        color = values["color"]
        if isinstance(color, str):
            node = image_node(nodes, links, description["textures"][color])
            links.new(node.outputs["Color"], shader.inputs["Color"])
        else:
            shader.inputs["Color"].default_value = (*triple(color), 1)
    links.new(shader.outputs["BSDF"], output.inputs["Surface"])
    return result


def add_mesh(shape, materials):
    bpy.ops.wm.obj_import(filepath=str(scene_file.parent / shape["file"]), forward_axis="Y",
                          up_axis="Z", use_split_objects=False)
    for item in bpy.context.selected_objects:
        item.data.materials.clear()
        item.data.materials.append(materials[shape["material"]])
        if shape.get("normals") == "smooth":
            item.data.shade_smooth()


def add_lamp(lamp):
    a, b, c, d = map(Vector, lamp["vertices"])
    radiance = triple(lamp["radiance"])
    strength = max(radiance)
    light = bpy.data.lights.new("lamp", "AREA")
    light.shape = "RECTANGLE"
    light.size, light.size_y = (b - a).length, (d - a).length
    # A lamp of radiance L and area A has the power pi A L.
    light.energy = LAMP_SCALE * math.pi * light.size * light.size_y * strength
    light.color = [x / strength for x in radiance]
    item = bpy.data.objects.new("lamp", light)
    item.visible_camera = True
    # It shines along its -z.
    x, y = (b - a).normalized(), (d - a).normalized()
    front = x.cross(y)
    item.matrix_world = Matrix.Translation((a + c) / 2) @ Matrix((x, -y, -front)).transposed(
        ).to_4x4()
    bpy.context.scene.collection.objects.link(item)


def add_camera(values):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle = math.radians(values["fov"])
    camera.clip_start = 1e-3
    item = bpy.data.objects.new("camera", camera)
    position, target = Vector(values["position"]), Vector(values["target"])
    z = (position - target).normalized()
    x = Vector((0, 1, 0)).cross(z).normalized()
    item.matrix_world = Matrix.Translation(position) @ Matrix(
        (x, z.cross(x), z)).transposed().to_4x4()
    bpy.context.scene.collection.objects.link(item)
    bpy.context.scene.camera = item


def set_up():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    materials = {name: material(name) for name in description["materials"]}
    for shape in description["shapes"]:
        add_mesh(shape, materials)
    for lamp in description["lights"]:
        add_lamp(lamp)
    add_camera(description["camera"])
    scene.world = bpy.data.worlds.new("world")
    nodes, links = nodes_of(scene.world)
    background, output = nodes.new("ShaderNodeBackground"), nodes.new("ShaderNodeOutputWorld")
    background.inputs["Color"].default_value = (*triple(description["background"]), 1)
    links.new(background.outputs["Background"], output.inputs["Surface"])

    render, cycles, film = scene.render, scene.cycles, description["film"]
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = film["width"], film["height"]
    render.resolution_percentage = 100
    render.use_persistent_data = True
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    bounces = description["render"]["max_bounces"]
    for kind in ("max", "diffuse", "glossy", "transmission"):
        setattr(cycles, f"{kind}_bounces", bounces)
    cycles.transparent_max_bounces = 32
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = cycles.light_sampling_threshold = 0
    cycles.pixel_filter_type = "BOX"
    return scene


def save(scene, picture):
    exr = picture + ".exr"
    bpy.data.images["Render Result"].save_render(exr, scene=scene)
    image = bpy.data.images.load(exr)
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    values = array.array("f", [0.0]) * (4 * width * height)
    image.pixels.foreach_get(values)
    bpy.data.images.remove(image)
    rgb = array.array("f", (values[4 * (i // 3) + i % 3] for i in range(3 * width * height)))
    with open(picture, "wb") as file:  # rows from the bottom, as in Blender
        file.write(f"PF\n{width} {height}\n-1.0\n".encode())
        rgb.tofile(file)


scene = set_up()


def render(request):
    cycles = scene.cycles
    cycles.samples, cycles.seed = request["spp"], request["seed"]
    cycles.use_adaptive_sampling = request.get("adaptive", False)
    cycles.adaptive_threshold = request.get("threshold", 0.0)
    cycles.use_light_tree = request.get("light_tree", True)
    cycles.use_denoising = request.get("denoise", False)
    start = time.perf_counter()
    bpy.ops.render.render()
    seconds = time.perf_counter() - start
    if request["picture"]:
        save(scene, request["picture"])
    return seconds


render({"spp": 1, "seed": 0, "picture": ""})
print("ready", file=answers, flush=True)
for line in sys.stdin:
    print(json.dumps({"seconds": render(json.loads(line))}), file=answers, flush=True)
