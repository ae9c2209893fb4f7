#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes resources/samples/scan-with-holes.stl: a machine's hand wheel as a scanner would deliver it.

An implicit surface is polygonised by surface nets, relaxed, roughened with scanner noise, and then damaged: holes,
turned faces, a double face, a face without area, a flake floating beside the part. Only + - * / and square roots are
used, so every machine makes the same bytes.

usage: tools/make-sample.py OUT.stl        (about 10 s)
"""

import random
import struct
import sys
from math import floor, sqrt

CELL = 1.2  # mm, edge of a grid cell and so about the length of a triangle's edge
LOW, HIGH = (-81.0, -81.0, -24.0), (81.0, 81.0, 82.0)

# The wheel, in mm; its axis is z, the rim lies in z = 0.
RIM_RADIUS, RIM_TUBE, RIM_WAVE = 68.0, 8.0, 0.55
HUB_RADIUS, HUB_LOW, HUB_HIGH, HUB_ROUNDING = 18.0, -21.0, 9.0, 2.5
BORE_RADIUS, KEY_HALF_WIDTH, KEY_DEPTH = 7.5, 2.6, 10.6
SPOKE_FROM, SPOKE_DROP, SPOKE_BEND = 12.0, -9.0, 7.0
COS_72, SIN_72 = (sqrt(5.0) - 1.0) / 4.0, sqrt(10.0 + 2.0 * sqrt(5.0)) / 4.0
SPOKES = [(1.0, 0.0)]
for _ in range(4):
    cx, cy = SPOKES[-1]
    SPOKES.append((cx * COS_72 - cy * SIN_72, cx * SIN_72 + cy * COS_72))
# The grip on the first spoke's end: (height, radius), joined by straight lines.
GRIP = ((6.0, 4.8), (15.0, 4.8), (17.5, 6.6), (19.5, 8.6), (25.0, 9.4), (33.0, 10.3), (42.0, 11.2), (50.0, 11.8),
        (55.0, 11.8), (60.0, 11.0), (64.0, 9.6), (67.0, 7.6), (69.5, 4.6), (70.5, 2.0))


# --- vectors ---------------------------------------------------------------------------------------------------------

def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def length(a):
    return sqrt(dot(a, a))


def mean(points):
    # Not sum(): Python 3.12 began to round it differently.
    total = (0.0, 0.0, 0.0)
    for p in points:
        total = (total[0] + p[0], total[1] + p[1], total[2] + p[2])
    return (total[0] / len(points), total[1] / len(points), total[2] / len(points))


def hypotenuse(a, b):
    return sqrt(a * a + b * b)


# --- the surface: f(x, y, z) < 0 inside ------------------------------------------------------------------------------

def smooth_min(a, b, k):
    h = k - abs(a - b)
    return min(a, b) if h <= 0.0 else min(a, b) - h * h / (4.0 * k)


def smooth_max(a, b, k):
    return -smooth_min(-a, -b, k)


def rim(x, y, z, rho):
    c = x / rho if rho > 1e-9 else 1.0
    c5 = ((16.0 * c * c - 20.0) * c * c + 5.0) * c  # cos 5a, doubled twice: cos 20a, a wave for each finger
    c10 = 2.0 * c5 * c5 - 1.0
    wave = 2.0 * c10 * c10 - 1.0
    return hypotenuse(rho - RIM_RADIUS, z) - RIM_TUBE - RIM_WAVE * wave


def hub(z, rho):
    middle, half = (HUB_HIGH + HUB_LOW) / 2.0, (HUB_HIGH - HUB_LOW) / 2.0
    taper = 0.1 * (z - HUB_LOW)
    a = rho + taper - HUB_RADIUS + HUB_ROUNDING
    b = abs(z - middle) - half + HUB_ROUNDING
    return min(max(a, b), 0.0) + hypotenuse(max(a, 0.0), max(b, 0.0)) - HUB_ROUNDING


def spoke(x, y, z):
    """The nearest of five curved spokes with elliptic section."""
    best, dx, dy = -1e9, 1.0, 0.0
    for ux, uy in SPOKES:
        along = x * ux + y * uy
        if along > best:
            best, dx, dy = along, ux, uy
    side = y * dx - x * dy
    t = (best - SPOKE_FROM) / (RIM_RADIUS - SPOKE_FROM)
    t = min(max(t, 0.0), 1.0)
    beyond = best - SPOKE_FROM - t * (RIM_RADIUS - SPOKE_FROM)
    v = side - SPOKE_BEND * 4.0 * t * (1.0 - t)
    w = z - SPOKE_DROP * (1.0 - t * t * (3.0 - 2.0 * t))
    width, height = 7.5 - 2.3 * t, 5.0 - 0.8 * t
    return (length((v / width, w / height, beyond / height)) - 1.0) * height


def grip(x, y, z):
    r = hypotenuse(x - RIM_RADIUS, y)
    profile = GRIP[-1][1]
    for (z0, r0), (z1, r1) in zip(GRIP, GRIP[1:]):
        if z < z1:
            profile = r0 + (r1 - r0) * max(z - z0, 0.0) / (z1 - z0)
            break
    return max(smooth_max(r - profile, z - GRIP[-1][0], 2.0), GRIP[0][0] - z)


def surface(x, y, z):
    rho = hypotenuse(x, y)
    d = smooth_min(rim(x, y, z, rho), spoke(x, y, z), 6.0)
    d = smooth_min(d, hub(z, rho), 5.0)
    if x > 40.0:
        d = smooth_min(d, grip(x, y, z), 3.0)
    d = smooth_max(d, BORE_RADIUS - rho, 1.6)
    return smooth_max(d, -max(abs(y) - KEY_HALF_WIDTH, x - KEY_DEPTH, -x), 0.8)


# --- triangles -------------------------------------------------------------------------------------------------------

def sampled():
    """Grid values near the surface; {} elsewhere. Blocks that the surface cannot reach are left out."""
    count = [int((h - l) / CELL) + 1 for l, h in zip(LOW, HIGH)]
    block, values = 4, {}
    reach = 2.0 * CELL * (block + 1)
    for bi in range(0, count[0], block):
        for bj in range(0, count[1], block):
            for bk in range(0, count[2], block):
                centre = [l + CELL * (b + block / 2) for l, b in zip(LOW, (bi, bj, bk))]
                if abs(surface(*centre)) > reach:
                    continue
                for i in range(bi, bi + block):
                    for j in range(bj, bj + block):
                        for k in range(bk, bk + block):
                            values[i, j, k] = surface(LOW[0] + CELL * i, LOW[1] + CELL * j, LOW[2] + CELL * k)
    return values


AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def surface_nets(values):
    """Vertices, one for each cell that the surface passes, and quadrangles, one for each grid edge that it crosses."""
    sums, quads = {}, []
    for (i, j, k), a in values.items():
        for axis, (di, dj, dk) in enumerate(AXES):
            b = values.get((i + di, j + dj, k + dk))
            if b is None or (a < 0.0) == (b < 0.0):
                continue
            t = a / (a - b)
            p = (i + di * t, j + dj * t, k + dk * t)
            u, v = AXES[(axis + 1) % 3], AXES[(axis + 2) % 3]
            cells = [(i - su * u[0] - sv * v[0], j - su * u[1] - sv * v[1], k - su * u[2] - sv * v[2])
                     for su, sv in ((0, 0), (1, 0), (1, 1), (0, 1))]
            for cell in cells:
                s = sums.setdefault(cell, [0.0, 0.0, 0.0, 0])
                for c in range(3):
                    s[c] += p[c]
                s[3] += 1
            quads.append(cells if a < 0.0 else cells[::-1])
    number = {cell: n for n, cell in enumerate(sorted(sums))}
    points = [tuple(LOW[c] + CELL * sums[cell][c] / sums[cell][3] for c in range(3)) for cell in sorted(sums)]
    return points, sorted([number[c] for c in q] for q in quads)


def gradient(p):
    e, f = 1e-4, surface(*p)
    return f, tuple((surface(*(p[c] + (e if c == a else 0.0) for c in range(3))) - f) / e for a in range(3))


def relaxed(points, quads):
    """Moves vertices to the middle of their neighbours along the surface, then back onto it."""
    neighbours = [set() for _ in points]
    for q in quads:
        for a, b in zip(q, q[1:] + q[:1]):
            neighbours[a].add(b)
            neighbours[b].add(a)
    normals = [None] * len(points)
    for _ in range(3):
        moved = []
        for n, p in enumerate(points):
            f, g = gradient(p)
            gg = dot(g, g) or 1.0
            step = subtract(mean([points[m] for m in sorted(neighbours[n])]), p)
            along = dot(step, g) / gg
            moved.append(tuple(p[c] + 0.6 * (step[c] - along * g[c]) - f * g[c] / gg for c in range(3)))
            normals[n] = tuple(c / sqrt(gg) for c in g)
        points = moved
    return points, normals


def triangulated(points, quads):
    """Each quadrangle cut along its shorter diagonal."""
    triangles = []
    for a, b, c, d in quads:
        if length(subtract(points[a], points[c])) < length(subtract(points[b], points[d])):
            triangles += [(a, b, c), (a, c, d)]
        else:
            triangles += [(a, b, d), (b, c, d)]
    return triangles


# --- noise -----------------------------------------------------------------------------------------------------------

class Noise:
    """Values between -1 and 1 that vary smoothly over the given distance in mm."""

    def __init__(self, seed, distance):
        self.random, self.distance, self.lattice = random.Random(seed), distance, {}
        self.table = [2.0 * self.random.random() - 1.0 for _ in range(4096)]

    def at_corner(self, i, j, k):
        return self.table[(i * 73 + j * 179 + k * 283 + (i * j ^ k * 7)) % 4096]

    def __call__(self, p):
        cell = [floor(c / self.distance) for c in p]
        t = [c / self.distance - i for c, i in zip(p, cell)]
        t = [c * c * (3.0 - 2.0 * c) for c in t]
        value = 0.0
        for corner in range(8):
            o = (corner & 1, corner >> 1 & 1, corner >> 2)
            weight = 1.0
            for c in range(3):
                weight *= t[c] if o[c] else 1.0 - t[c]
            value += weight * self.at_corner(cell[0] + o[0], cell[1] + o[1], cell[2] + o[2])
        return value


def roughened(points, normals):
    """What a cast surface and a hand-held scanner add: dents of the casting, ripples, and grain of about 0.02 mm."""
    casting, ripples, grain = Noise(1, 14.0), Noise(2, 4.0), random.Random(3)
    rough = []
    for p, n in zip(points, normals):
        d = 0.18 * casting(p) + 0.05 * ripples(p) + 0.02 * (grain.random() + grain.random() + grain.random() - 1.5)
        rough.append(tuple(p[c] + d * n[c] for c in range(3)))
    return rough


# --- damage ----------------------------------------------------------------------------------------------------------

# Where the scanner saw nothing: centre, radius and raggedness, and a plane (normal, offset) that bounds the region.
HOLES = (
    ("rim, half of the tube", (-48.0, -48.0, 4.0), 20.0, 0.3, ((-0.5, -0.5, 0.7), 46.0)),
    ("edge of the hub", (4.0, 15.3, 9.0), 6.5, 0.3, None),
    ("spoke at the rim, below", (18.0, 57.0, -5.5), 6.0, 0.4, ((0.0, 0.0, -1.0), 0.8)),
    ("end of the grip", (73.0, -2.0, 69.0), 5.5, 0.35, None),
    ("in the bore", (-7.5, 0.0, -10.0), 5.0, 0.3, None),
    ("rim, outside", (60.0, -45.0, -2.0), 2.6, 0.2, None),
    ("one triangle of a spoke", (-10.0, -34.0, 0.0), 0.0, 0.0, None),
)


def adjacency(triangles):
    edges = {}
    for f, t in enumerate(triangles):
        for a, b in zip(t, t[1:] + t[:1]):
            edges.setdefault((min(a, b), max(a, b)), []).append(f)
    neighbours = [[] for _ in triangles]
    for pair in edges.values():
        if len(pair) == 2:
            neighbours[pair[0]].append(pair[1])
            neighbours[pair[1]].append(pair[0])
    return neighbours


def without_holes(points, triangles):
    ragged = Noise(4, 4.0)
    middle = [mean([points[v] for v in t]) for t in triangles]
    neighbours = adjacency(triangles)
    gone = set()
    for _, centre, radius, roughness, plane in HOLES:
        def inside(f):
            p = middle[f]
            if plane and dot(plane[0], p) < plane[1]:
                return False
            return length(subtract(p, centre)) < radius * (1.0 + roughness * ragged(p))
        first = min(range(len(triangles)), key=lambda f: length(subtract(middle[f], centre)))
        region, front = {first}, [first]
        while front:
            for f in neighbours[front.pop()]:
                if f not in region and inside(f):
                    region.add(f)
                    front.append(f)
        gone |= region
    return largest_part(without_pinches([t for f, t in enumerate(triangles) if f not in gone]))


def without_pinches(triangles):
    """Removes faces until each vertex has one fan: a border that touches itself at a vertex is a defect of its own."""
    while True:
        around = {}
        for f, t in enumerate(triangles):
            for v in t:
                around.setdefault(v, []).append(f)
        gone = set()
        for v, faces in around.items():
            fans = []
            for f in faces:
                others = {w for w in triangles[f] if w != v}
                touching = [fan for fan in fans if fan[0] & others]
                fans = [fan for fan in fans if fan not in touching]
                fans.append((others.union(*(fan[0] for fan in touching)), sum((fan[1] for fan in touching), [f])))
            if len(fans) > 1:
                fans.sort(key=lambda fan: (len(fan[1]), fan[1]))
                gone.update(f for fan in fans[:-1] for f in fan[1])
        if not gone:
            return triangles
        triangles = [t for f, t in enumerate(triangles) if f not in gone]


def largest_part(triangles):
    neighbours, part, best = adjacency(triangles), set(), set()
    left = set(range(len(triangles)))
    while left:
        part, front = set(), [min(left)]
        part.add(front[0])
        while front:
            for f in neighbours[front.pop()]:
                if f not in part:
                    part.add(f)
                    front.append(f)
        left -= part
        best = max(best, part, key=len)
    return [t for f, t in enumerate(triangles) if f in best]


def flake(points, centre, radius):
    """A small closed shell: an octahedron out of shape."""
    grain, first = random.Random(5), len(points)
    for axis in AXES:
        for sign in (1.0, -1.0):
            stretch = sign * radius * (0.6 + 0.6 * grain.random())
            points.append(tuple(centre[c] + stretch * axis[c] for c in range(3)))
    px, nx, py, ny, pz, nz = range(first, first + 6)
    upper = [(px, py, pz), (py, nx, pz), (nx, ny, pz), (ny, px, pz)]
    lower = [(py, px, nz), (nx, py, nz), (ny, nx, nz), (px, ny, nz)]
    return upper + lower


def damaged(points, triangles):
    triangles = without_holes(points, triangles)
    count = len(triangles)
    for f in (count // 7, count // 3, 4 * count // 5):
        a, b, c = triangles[f]
        triangles[f] = (a, c, b)
    a, b, c = triangles[count // 2]
    triangles.append((b, c, a))                 # once more
    triangles.append((a, a, b))                 # without area
    triangles += flake(points, (46.0, 31.0, 14.0), 1.4)
    return triangles


# --- file ------------------------------------------------------------------------------------------------------------

def binary_stl(points, triangles):
    single = [struct.unpack("<3f", struct.pack("<3f", p[0], p[1], p[2] - LOW[2])) for p in points]
    data = [struct.pack("<80sI", b"Hand wheel with holes, made by tools/make-sample.py", len(triangles))]
    for a, b, c in triangles:
        n = cross(subtract(single[b], single[a]), subtract(single[c], single[a]))
        size = length(n) or 1.0
        data.append(struct.pack("<12fH", *(x / size for x in n), *single[a], *single[b], *single[c], 0))
    return b"".join(data)


def main():
    points, quads = surface_nets(sampled())
    points, normals = relaxed(points, quads)
    points = roughened(points, normals)
    data = binary_stl(points, damaged(points, triangulated(points, quads)))
    with open(sys.argv[1], "wb") as stream:
        stream.write(data)
    print(f"{sys.argv[1]}: {(len(data) - 84) // 50} triangles, {len(data)} bytes")


if __name__ == "__main__":
    main()
