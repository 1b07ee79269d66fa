"""Scenes that Calotype, Mitsuba and Cycles can render alike.

Each is a folder with scene.json, which Calotype reads, and meshes in the coordinates of the world,
each of one material. The workers of the peers translate scene.json. It has a pinhole camera,
diffuse materials (a colour or an image) and clear glass, rectangular lamps that shine from their
front, and a background of one colour.
"""

import json
import math
import pathlib
import shutil
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
ASSETS = ROOT / "assets"
CONFERENCE = ROOT.parent / "shared/data/conference-room/conference.zip"
WHITE, RED, GREEN = 0.73, [0.61, 0.06, 0.05], [0.12, 0.44, 0.09]


class SceneFolder:
    def __init__(self, folder, camera, background=0.0, max_bounces=8):
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True)
        self.scene = {"camera": camera, "render": {"max_bounces": max_bounces},
                      "background": background,
                      "textures": {}, "materials": {}, "shapes": [], "lights": []}

    def diffuse(self, name, color):
        self.scene["materials"][name] = {"type": "diffuse", "color": color}

    def glass(self, name):
        self.scene["materials"][name] = {"type": "dielectric", "ior": 1.5}

    def image(self, name, scale):
        """A diffuse material of an image of assets/."""
        shutil.copy(ASSETS / f"{name}_color.png", self.folder)
        self.scene["textures"][name] = {"type": "image", "file": f"{name}_color.png",
                                        "scale": scale}
        self.diffuse(name, name)

    def mesh(self, lines, material, smooth=False):
        file = f"mesh{len(self.scene['shapes'])}.obj"
        (self.folder / file).write_text("\n".join(lines) + "\n")
        shape = {"type": "mesh", "file": file, "material": material}
        self.scene["shapes"].append({**shape, "normals": "smooth"} if smooth else shape)

    def quad(self, corners, material):
        self.mesh([f"v {x} {y} {z}" for x, y, z in corners] + ["f 1 2 3 4"], material)

    def ball(self, center, radius, material, rings=64):
        self.mesh(ball(center, radius, rings), material, smooth=True)

    def asset(self, name, *arguments, **options):
        self.model(ASSETS / f"{name}.obj", *arguments, **options)

    def model(self, file, materials, smooth=False, translate=(0, 0, 0), turn=0.0, scale=(1, 1, 1)):
        """An OBJ file, cut into one mesh for each of the materials; others are left out."""
        for part, lines in parts(file, translate, turn, scale).items():
            if part in materials:
                self.mesh(lines, materials[part], smooth)

    def lamp(self, corners, radiance):
        """A parallelogram that is a rectangle; its front is where the corners turn left."""
        self.scene["lights"].append({"type": "quad", "vertices": corners, "radiance": radiance})

    def write(self, size):
        self.scene["film"] = {"width": size, "height": size}
        (self.folder / "scene.json").write_text(json.dumps(self.scene))
        return self.folder / "scene.json"


def ball(center, radius, rings):
    lines, segments = [], 2 * rings
    for i in range(rings + 1):
        for j in range(segments):
            theta, phi = math.pi * i / rings, 2 * math.pi * j / segments
            point = (math.sin(theta) * math.cos(phi), math.cos(theta),
                     -math.sin(theta) * math.sin(phi))
            lines.append("v " + " ".join(f"{c + radius * x:.9g}" for c, x in zip(center, point)))
    for i in range(rings):
        for j in range(segments):
            a, b = segments * i + j + 1, segments * i + (j + 1) % segments + 1
            c, d = b + segments, a + segments
            if i > 0:
                lines.append(f"f {a} {d} {b}")
            if i < rings - 1:
                lines.append(f"f {b} {d} {c}")
    return lines


class Part:
    """The faces of one material, with the vertices and texture coordinates that they use."""

    def __init__(self):
        self.lines, self.faces, self.indices = [], [], {}

    def add(self, corners, tables):
        self.faces.append("f " + " ".join(
            "/".join(self.index(kind, int(text), tables) if text else ""
                     for kind, text in zip(("v", "vt"), corner.split("/")))
            for corner in corners))

    def index(self, kind, number, tables):
        table = tables[kind]
        line = table[number - 1 if number > 0 else number]
        known = self.indices.setdefault(kind, {})
        if line not in known:
            known[line] = str(len(known) + 1)
            self.lines.append(line)
        return known[line]


def parts(file, translate, turn, scale):
    """Lines of an OBJ file by material, without its normals: where they point into a face's back,
    the face is black in Mitsuba alone."""
    sine, cosine = math.sin(math.radians(turn)), math.cos(math.radians(turn))

    def turned(x, y, z):
        return cosine * x + sine * z, y, cosine * z - sine * x
    tables, result, material = {"v": [], "vt": []}, {}, ""
    for line in file.read_text().splitlines():
        word, *values = line.split() or [""]
        if word == "v":
            point = turned(*(float(value) * s for value, s in zip(values, scale)))
            line = "v " + " ".join(f"{x + t:.7g}" for x, t in zip(point, translate))
        elif word == "usemtl":
            material = values[0]
        elif word == "f":
            result.setdefault(material, Part()).add(values, tables)
        if word in tables:
            tables[word].append(line)
    return {material: part.lines + part.faces for material, part in result.items()}


def box(scene, sides=(RED, GREEN)):
    """The room of scenes/cornell-box.json without what stands in it."""
    scene.diffuse("white", WHITE)
    scene.diffuse("left", sides[0])
    scene.diffuse("right", sides[1])
    scene.quad([[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], "white")
    scene.quad([[-1, 2, -1], [1, 2, -1], [1, 2, 1], [-1, 2, 1]], "white")
    scene.quad([[-1, 0, -1], [1, 0, -1], [1, 2, -1], [-1, 2, -1]], "white")
    scene.quad([[-1, 0, 1], [-1, 0, -1], [-1, 2, -1], [-1, 2, 1]], "left")
    scene.quad([[1, 0, -1], [1, 0, 1], [1, 2, 1], [1, 2, -1]], "right")


BOX_CAMERA = {"position": [0, 1, 3.85], "target": [0, 1, 0], "fov": 39}


def ceiling_lamp(x, z, half, height=1.99):
    return [[x - half, height, z - half], [x + half, height, z - half],
            [x + half, height, z + half], [x - half, height, z + half]]


def cornell_box(folder):
    scene = SceneFolder(folder, BOX_CAMERA)
    box(scene)
    cube = {"": "white"}
    scene.asset("cube", cube, translate=(-0.35, 0.6, -0.3), turn=18, scale=(0.6, 1.2, 0.6))
    scene.asset("cube", cube, translate=(0.36, 0.3, 0.34), turn=-17, scale=(0.6, 0.6, 0.6))
    scene.lamp(ceiling_lamp(0, 0, 0.25), [18, 14, 8])
    return scene


def glass_room(folder):
    scene = SceneFolder(folder, BOX_CAMERA)
    box(scene)
    scene.glass("glass")
    scene.ball((-0.4, 0.45, -0.2), 0.45, "glass")
    scene.ball((0.45, 0.3, 0.35), 0.3, "white")
    scene.lamp(ceiling_lamp(0, 0, 0.4), [7, 6, 4])
    return scene


def lamp_room(folder):
    """400 lamps in a lattice under the ceiling, and balls on the floor."""
    scene = SceneFolder(folder, BOX_CAMERA)
    box(scene)
    for number in range(12):
        angle = 2.4 * number
        radius = 0.25 * math.sqrt(number)
        scene.ball((radius * math.cos(angle), 0.13, radius * math.sin(angle)), 0.13, "white", 24)
    for i in range(20):
        for j in range(20):
            color = [(20, 5, 3), (5, 16, 6), (4, 7, 22), (12, 10, 7)][(i + 2 * j) % 4]
            scene.lamp(ceiling_lamp(-0.95 + 0.1 * i, -0.95 + 0.1 * j, 0.01,
                                    1.7 + 0.02 * ((7 * i + 3 * j) % 11)), [3 * c for c in color])
    return scene


def conference_room(folder):
    """Of ../shared/data, in the diffuse colours of its MTL file; nothing where it is not there."""
    if not CONFERENCE.exists():
        return None
    scene = SceneFolder(folder, {"position": [-2.4, 1.25, 0.9], "target": [2.4, 0.75, -0.9],
                                 "fov": 50})
    zipfile.ZipFile(CONFERENCE).extractall(scene.folder)
    for line in (scene.folder / "conference.mtl").read_text().splitlines():
        word, *values = line.split() or [""]
        if word == "newmtl":
            name = values[0]
        elif word == "Kd":
            scene.diffuse(name, [float(value) for value in values])
    scene.model(scene.folder / "conference.obj",
                {material: material for material in scene.scene["materials"]},
                scale=(0.003,) * 3)
    for z in (-1.6, 0.2):
        scene.lamp([[-1.5, 1.85, z], [3, 1.85, z], [3, 1.85, z + 0.6], [-1.5, 1.85, z + 0.6]], 10)
    return scene


ATELIER_CAMERA = {"position": [0.32, 1.30, 3.05], "target": [0.03, 0.83, -0.1], "fov": 33}
COLORS = {"ceiling": [0.76, 0.72, 0.62], "panelling": [0.29, 0.38, 0.33],
          "trim": [0.71, 0.68, 0.59], "linen": [0.72, 0.67, 0.56], "wood": [0.27, 0.13, 0.05],
          "dark": [0.12, 0.05, 0.03], "rush": [0.45, 0.33, 0.13], "brass": [0.6, 0.45, 0.2],
          "paper": [0.6, 0.5, 0.4], "soil": [0.04, 0.03, 0.02], "green": [0.1, 0.16, 0.05],
          "pot": [0.3, 0.16, 0.09]}


def atelier_room(folder, background=0.0):
    """The room of scenes/atelier.json and its furniture in diffuse materials, 62,000 triangles."""
    scene = SceneFolder(folder, ATELIER_CAMERA, background)
    for name, color in COLORS.items():
        scene.diffuse(name, color)
    scene.image("parquet", [1.5, 1.5])
    scene.image("damask", [1.6, 1.6])
    scene.image("walnut", [6, 2])
    scene.asset("walls", {"wall": "damask", "floor": "parquet", "ceiling": "ceiling",
                          "panelling": "panelling"})
    scene.asset("wainscot", {"panelling": "panelling"})
    scene.asset("window", {"trim": "trim"})
    scene.asset("picture_frame", {"walnut": "wood", "mount": "paper", "print_sky": "rush",
                                  "print_hills": "wood", "print_land": "dark"},
                translate=(0.66, 1.62, -1.6999))
    scene.asset("table", {"oak": "walnut"}, translate=(-0.36, 0, -0.1))
    scene.asset("table_cloth", {"linen": "linen"}, True, (-0.36, 0, -0.1), 20)
    scene.asset("curtain", {"linen": "linen"}, True, (-1.53, 0.02, -0.8), 90, (0.45, 2.8, 0.9))
    scene.asset("view_camera", {"mahogany": "wood", "oak": "rush", "brass": "brass",
                                "leather": "dark", "groundglass": "paper", "lens": "soil"},
                translate=(0.36, 0, -0.85), turn=216)
    scene.asset("chair", {"chairwood": "walnut", "rush": "rush", "piping": "dark"},
                translate=(0.53, 0, 0.02), turn=212)
    scene.lamp([[-1.665, 1.001, 0.849], [-1.665, 1.001, -0.749],
                [-1.665, 2.599, -0.749], [-1.665, 2.599, 0.849]], [9.2, 9.9, 10.5])
    return scene


def textured_interior(folder):
    """The atelier's room under lamp and background."""
    return atelier_room(folder, 0.4)


def atelier(folder):
    """The nearest to scenes/atelier.json: its glass hare and plants, but diffuse materials, no maps
    but of colour, no quadrics, no displacement."""
    scene = atelier_room(folder)
    scene.glass("glass")
    scene.asset("hare", {"hare": "glass"}, True, (-0.345, 0.7968, -0.16), -8, (1.55,) * 3)
    plant = {"pot": "pot", "soil": "soil", "stem": "green", "leaf": "green"}
    scene.asset("rubber_plant", plant, True, (-0.86, 0.022, -1.05))
    scene.asset("monstera", plant, False, (0.98, 0, -1.15), 0, (1.35,) * 3)
    scene.lamp([[2.4436, 1.8051, 2.5941], [1.2234, 1.8051, 3.2805],
                [0.9564, 3.0949, 2.8059], [2.1766, 3.0949, 2.1195]], [5.2, 4.4, 3.5])
    return scene


SCENES = {"atelier": atelier, "cornell-box": cornell_box, "glass-room": glass_room,
          "lamp-room": lamp_room, "conference-room": conference_room,
          "textured-interior": textured_interior}


def make(name, folder, size):
    """The file of a scene of size x size pixels, or nothing where its data is not there."""
    scene = SCENES[name](folder)
    return scene.write(size) if scene else None
