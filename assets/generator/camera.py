"""A wooden view camera with bellows, on its tripod."""

import math

from generator import surfaces, vectors
from generator.mesh import Mesh
from generator.surfaces import beam, box, lathe, profile
from generator.vectors import Frame

AXIS = 1.17  # height of the optical axis above the floor
BED = 0.985  # top of the bed
REAR, FRONT = -0.15, 0.19  # the two standards along X
KNOB = profile("0,0 8,0 9,1 9,12 16,13 17,15 17,22 15,24 0,24")


def view_camera():
    """The tripod stands on y = 0 about the origin; the lens looks along +X."""
    mesh = Mesh("view_camera")
    _bed(mesh)
    _rear_standard(mesh)
    _front_standard(mesh)
    mesh.add("leather", _bellows(REAR + 0.032, FRONT - 0.012, 0.108, 0.074, 15))
    _lens(mesh)
    _tripod(mesh)
    return mesh


def at(x, y, z):
    return Frame((x, y, z))


def _bed(mesh):
    mesh.add("mahogany", box((0.46, 0.022, 0.19), 0.004), at(0.02, BED - 0.011, 0))
    for z in (-0.07, 0.07):
        mesh.add("mahogany", box((0.44, 0.014, 0.02), 0.002), at(0.02, BED + 0.0068, z))
        mesh.add("brass", box((0.44, 0.003, 0.008), 0.001), at(0.02, BED + 0.0152, z))
    for z in (-1, 1):
        outward = Frame((0.13, BED - 0.011, z * 0.0949), (1, 0, 0), (0, 0, z))
        mesh.add("brass", lathe(KNOB, 32), outward)


def _frame(mesh, x, outer, rail, depth):
    """Four mahogany rails about the optical axis."""
    side = outer / 2 - rail / 2
    for sign in (-1, 1):
        mesh.add("mahogany", box((depth, outer, rail), 0.003), at(x, AXIS, sign * side))
        across = box((depth, rail, outer - 2 * rail + 0.002), 0.003)
        mesh.add("mahogany", across, at(x, AXIS + sign * side, 0))


def _rear_standard(mesh):
    _frame(mesh, REAR, 0.290, 0.030, 0.064)
    mesh.add("mahogany", box((0.060, 0.050, 0.150), 0.003), at(REAR, BED + 0.0165 + 0.0245, 0))
    mesh.add("groundglass", box((0.006, 0.232, 0.232), 0.001), at(REAR - 0.020, AXIS, 0))
    for z in (-0.1, 0.1):  # the clips of the plate holder
        mesh.add("brass", box((0.006, 0.030, 0.012), 0.002), at(REAR - 0.0349, AXIS + 0.13, z))
    arch = profile("-60,144 -50,162 0,168 50,162 60,144")
    handle = surfaces.spline([(REAR, AXIS + y, z) for z, y in arch], 10)
    mesh.add("leather", surfaces.tube(handle, [0.006] * len(handle), 16, (1, 0, 0)))


def _front_standard(mesh):
    _frame(mesh, FRONT, 0.200, 0.024, 0.026)
    mesh.add("mahogany", box((0.012, 0.154, 0.154), 0.001), at(FRONT, AXIS, 0))
    mesh.add("mahogany", box((0.008, 0.13, 0.13), 0.002), at(FRONT + 0.0099, AXIS, 0))
    mesh.add("mahogany", box((0.050, 0.022, 0.19), 0.003), at(FRONT, BED + 0.0165 + 0.0105, 0))
    for z in (-1, 1):
        foot, top = (FRONT, BED + 0.018, z * 0.1025), (FRONT, AXIS + 0.045, z * 0.1025)
        mesh.add("brass", beam(foot, top, 0.024, 0.006, 0.0015))
        outward = Frame((FRONT, AXIS, z * 0.1053), (1, 0, 0), (0, 0, z))
        mesh.add("brass", lathe(KNOB, 32), outward)


def _bellows(start, end, half_start, half_end, pleats):
    """A square bellows along X about the optical axis, from one half-width to another."""
    rows = []
    for k in range(2 * pleats + 1):
        t = k / (2 * pleats)
        half = half_start + (half_end - half_start) * t - (0.011 if k % 2 else 0.0)
        corner = half * (0.86 if k % 2 else 0.80)
        x = start + (end - start) * t
        quarter = [(-half, -corner), (-half, corner)]
        octagon = quarter + [(z, -y) for y, z in quarter]
        octagon += [(-y, -z) for y, z in octagon]
        rows.append([(x, AXIS + y, z) for y, z in octagon])
    return surfaces.grid(rows, wrap_columns=True, smooth=False)


def _lens(mesh):
    barrel = profile(
        "0,0 48,0 50,1 50,7 48,8 37.5,8.5 36,10 36,30 37,31 40,32 41,33 41,38 40,39 37,40 "
        "36,41 36,58 37,59.5 43,61 44,62 44,83 43,84 39,84 38,83 37.5,66"
    )
    forward = Frame((FRONT + 0.0138, AXIS, 0), (0, 1, 0), (1, 0, 0))
    mesh.add("brass", lathe(barrel, 64), forward)
    angles = [math.pi / 2 * (1 - k / 12) for k in range(13)]
    dome = [(0.038 * math.sin(a), 0.056 + 0.014 * math.cos(a)) for a in angles]
    mesh.add("lens", lathe(dome, 48), forward)


def _tripod(mesh):
    plate = profile("0,0 66,0 70,2 72,5 72,18 70,20 0,20")
    below = BED - 0.022 - 0.020
    mesh.add("brass", lathe(plate, 64), at(0, below + 0.0001, 0))
    hub = profile("0,0 30,0 34,4 34,46 30,50 0,50")
    mesh.add("brass", lathe(hub, 48), at(0, below - 0.0499, 0))
    for degrees in (60, 180, 300):
        _leg(mesh, vectors.about_y((0, 0, 0), math.radians(degrees)), below - 0.022)


def _leg(mesh, frame, top):
    """Two upper struts that hold a lower one between them, which ends in a brass spike."""
    hip, foot = (0.052, top, 0.0), (0.36, 0.0, 0.0)

    def along(t, z=0.0):
        p = vectors.mix(hip, foot, t)
        return (p[0], p[1], z)

    across = (0, 0, 1)
    for sign in (-1, 1):
        ends = along(-0.02, sign * 0.030), along(0.62, sign * 0.0165)
        mesh.add("oak", beam(*ends, 0.013, 0.026, 0.003, across), frame)
    mesh.add("brass", beam((0.030, top, -0.042), (0.030, top, 0.042), 0.012, 0.012, 0.003), frame)
    ends = along(-0.005, -0.041), along(-0.005, 0.041)
    mesh.add("brass", beam(*ends, 0.014, 0.014, 0.004), frame)
    mesh.add("oak", beam(along(0.30), along(0.955), 0.0195, 0.022, 0.003, across), frame)
    mesh.add("brass", beam(along(0.585), along(0.615), 0.052, 0.034, 0.003, across), frame)
    mesh.add("brass", beam(along(0.32), along(0.345), 0.060, 0.030, 0.003, across), frame)
    spike = [along(t) for t in (0.945, 0.950, 0.965, 0.970, 0.995, 1.0)]
    mesh.add("brass", surfaces.tube(spike, [0.013, 0.014, 0.014, 0.011, 0.005, 0.002], 24), frame)
