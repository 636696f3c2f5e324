#!/usr/bin/env python3
"""Writes lantern.gltf: a brass lantern and a chrome ball on a tiled floor, everything in one file.

usage: make_lantern.py lantern.gltf [--unlit]

--unlit puts the flame out: the light of the window, which has a direction and no place, is left.
"""

import base64
import json
import math
import struct
import sys
import zlib

buffer = bytearray()
views, accessors, meshes, nodes = [], [], [], []


def accessor(values, kind, target):
    """Appends rows of numbers to the buffer; returns the accessor's number. kind: VEC3, VEC2 or SCALAR (indices)."""
    while len(buffer) % 4:
        buffer.append(0)
    start = len(buffer)
    for row in values:
        buffer.extend(struct.pack("<H", row) if kind == "SCALAR" else struct.pack(f"<{len(row)}f", *row))
    views.append({"buffer": 0, "byteOffset": start, "byteLength": len(buffer) - start, "target": target})
    entry = {"bufferView": len(views) - 1, "componentType": 5123 if kind == "SCALAR" else 5126, "count": len(values),
             "type": kind}
    if kind == "VEC3" and target == 34962:
        entry["min"] = [min(struct.unpack("<f", struct.pack("<f", v[i]))[0] for v in values) for i in range(3)]
        entry["max"] = [max(struct.unpack("<f", struct.pack("<f", v[i]))[0] for v in values) for i in range(3)]
    accessors.append(entry)
    return len(accessors) - 1


def add_mesh(name, material, positions, normals, indices, uvs=None):
    attributes = {"POSITION": accessor(positions, "VEC3", 34962), "NORMAL": accessor(normals, "VEC3", 34962)}
    if uvs:
        attributes["TEXCOORD_0"] = accessor(uvs, "VEC2", 34962)
    meshes.append({"name": name, "primitives": [{"attributes": attributes,
                                                 "indices": accessor(indices, "SCALAR", 34963),
                                                 "material": material}]})
    return len(meshes) - 1


def normalised(v):
    length = math.sqrt(sum(x * x for x in v)) or 1.0
    return [x / length for x in v]


def lathe(profile, segments, smooth):
    """Turns a profile of (radius, height) points around the y axis. Between points the surface is flat in profile unless
    smooth. Returns positions, normals, indices."""
    positions, normals, indices = [], [], []

    def ring(radius, height, normal):
        first = len(positions)
        for k in range(segments):
            angle = 2.0 * math.pi * k / segments
            c, s = math.cos(angle), math.sin(angle)
            positions.append([radius * c, height, radius * s])
            normals.append(normalised([normal[0] * c, normal[1], normal[0] * s]))
        return first

    def side(p, q):
        return normalised([q[1] - p[1], p[0] - q[0]])

    def connect(below, above, closed_below, closed_above):
        for k in range(segments):
            n = (k + 1) % segments
            if not closed_below:
                indices.extend([below + k, above + n, below + n])
            if not closed_above:
                indices.extend([below + k, above + k, above + n])

    sides = [side(p, q) for p, q in zip(profile, profile[1:])]
    if smooth:
        rings = []
        for i, (radius, height) in enumerate(profile):
            around = sides[max(i - 1, 0):i + 1]
            rings.append(ring(radius, height, normalised([sum(n[j] for n in around) for j in range(2)])))
        for i in range(len(profile) - 1):
            connect(rings[i], rings[i + 1], profile[i][0] == 0, profile[i + 1][0] == 0)
    else:
        for (p, q), normal in zip(zip(profile, profile[1:]), sides):
            connect(ring(*p, normal), ring(*q, normal), p[0] == 0, q[0] == 0)
    return positions, normals, indices


def torus(radius, tube, segments, sides):
    positions, normals, indices = [], [], []
    for i in range(segments):
        a = 2.0 * math.pi * i / segments
        for j in range(sides):
            b = 2.0 * math.pi * j / sides
            n = [math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), math.sin(b)]
            positions.append([(radius + tube * math.cos(b)) * math.cos(a), (radius + tube * math.cos(b)) * math.sin(a),
                              tube * math.sin(b)])
            normals.append(n)
            right, up = (i + 1) % segments * sides, (j + 1) % sides
            indices.extend([i * sides + j, right + j, right + up, i * sides + j, right + up, i * sides + up])
    return positions, normals, indices


def tiles_png(size):
    """Four tiles in two stone colours with dark joints, as an 8-bit RGB PNG."""
    rows = bytearray()
    for y in range(size):
        rows.append(0)
        for x in range(size):
            half = size // 2
            joint = min(x % half, y % half) == 0
            light = (x // half + y // half) % 2 == 0
            colour = (52, 48, 44) if joint else (196, 182, 160) if light else (112, 96, 84)
            shade = 0 if joint else (x * 7 + y * 13 + (x * y) % 11) % 12 - 6
            rows.extend(max(0, min(255, c + shade)) for c in colour)

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


def look_at(eye, target):
    """Rotation quaternion (x, y, z, w) that turns -z towards the target, y upright."""
    z = normalised([e - t for e, t in zip(eye, target)])
    x = normalised([z[2], 0.0, -z[0]])
    y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]]
    w = math.sqrt(max(0.0, 1.0 + x[0] + y[1] + z[2])) / 2.0
    return [(y[2] - z[1]) / (4 * w), (z[0] - x[2]) / (4 * w), (x[1] - y[0]) / (4 * w), w]


TILES, BRASS, CHROME, WAX, IRON = range(5)
materials = [
    {"name": "tiles", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0.0,
                                               "roughnessFactor": 0.9}},
    {"name": "brass", "pbrMetallicRoughness": {"baseColorFactor": [0.78, 0.50, 0.16, 1.0], "metallicFactor": 1.0,
                                               "roughnessFactor": 0.35}},
    {"name": "chrome", "pbrMetallicRoughness": {"baseColorFactor": [0.86, 0.88, 0.90, 1.0], "metallicFactor": 1.0,
                                                "roughnessFactor": 0.08}},
    {"name": "wax", "pbrMetallicRoughness": {"baseColorFactor": [0.93, 0.86, 0.70, 1.0], "metallicFactor": 0.0,
                                             "roughnessFactor": 0.6}},
    {"name": "iron", "pbrMetallicRoughness": {"baseColorFactor": [0.05, 0.05, 0.06, 1.0], "metallicFactor": 0.3,
                                              "roughnessFactor": 0.7}},
]

floor = add_mesh("floor", TILES, [[-6, 0, -6], [6, 0, -6], [6, 0, 6], [-6, 0, 6]], [[0, 1, 0]] * 4,
                 [0, 3, 2, 0, 2, 1], [[0, 0], [9, 0], [9, 9], [0, 9]])
foot = add_mesh("foot", BRASS, *lathe([(0.62, 0.0), (0.66, 0.05), (0.62, 0.12), (0.50, 0.16), (0.46, 0.22), (0.52, 0.27),
                                       (0.50, 0.32), (0.0, 0.32)], 20, False))
candle = add_mesh("candle", WAX, *lathe([(0.15, 0.0), (0.15, 0.52), (0.12, 0.55), (0.0, 0.53)], 14, False))
wick = add_mesh("wick", IRON, *lathe([(0.012, 0.0), (0.010, 0.08), (0.0, 0.09)], 6, False))
post = add_mesh("post", BRASS, *lathe([(0.035, 0.0), (0.025, 0.1), (0.025, 1.0), (0.035, 1.1)], 7, True))
roof = add_mesh("roof", BRASS, *lathe([(0.0, 0.0), (0.62, 0.0), (0.64, 0.05), (0.42, 0.20), (0.20, 0.42), (0.13, 0.46),
                                       (0.13, 0.56), (0.0, 0.60)], 20, False))
ring = add_mesh("ring", BRASS, *torus(0.16, 0.025, 16, 5))
ball = add_mesh("ball", CHROME, *lathe([(0.42 * math.sin(math.pi * i / 10) if 0 < i < 10 else 0.0,
                                         -0.42 * math.cos(math.pi * i / 10)) for i in range(11)], 20, True))


def place(name, mesh, at, **more):
    nodes.append({"name": name, "mesh": mesh, "translation": at, **more})
    return len(nodes) - 1


parts = [place("foot", foot, [0, 0, 0]), place("candle", candle, [0, 0.32, 0]), place("wick", wick, [0, 0.85, 0]),
         place("roof", roof, [0, 1.42, 0]), place("ring", ring, [0, 2.17, 0])]
for corner in range(4):
    angle = math.pi / 4 + corner * math.pi / 2
    parts.append(place(f"post {corner + 1}", post, [0.44 * math.cos(angle), 0.32, 0.44 * math.sin(angle)]))
nodes.append({"name": "lantern", "children": parts, "rotation": [0.0, math.sin(0.2), 0.0, math.cos(0.2)]})
lantern = len(nodes) - 1
scene_nodes = [place("floor", floor, [0, 0, 0]), lantern, place("ball", ball, [1.15, 0.42, 0.55]),
               place("small ball", ball, [-1.05, 0.25, 0.75], scale=[0.6, 0.6, 0.6])]

eye, target = [1.2, 2.0, 4.7], [0.1, 0.98, 0.0]
nodes.append({"name": "camera", "camera": 0, "translation": eye, "rotation": look_at(eye, target)})
nodes.append({"name": "flame", "translation": [0, 1.12, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}})
nodes.append({"name": "window", "rotation": look_at([2.2, 3.0, 2.6], [0, 0, 0]),
              "extensions": {"KHR_lights_punctual": {"light": 1}}})
flame = [] if "--unlit" in sys.argv[2:] else [len(nodes) - 2]
scene_nodes += [len(nodes) - 3, *flame, len(nodes) - 1]

image = "data:image/png;base64," + base64.b64encode(tiles_png(32)).decode()
gltf = {
    "asset": {"version": "2.0", "generator": "make_lantern.py"},
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [
        {"name": "flame", "type": "point", "color": [1.0, 0.72, 0.38], "intensity": 5.0},
        {"name": "window", "type": "directional", "color": [0.75, 0.85, 1.0], "intensity": 1.6}]}},
    "scene": 0,
    "scenes": [{"name": "lantern", "nodes": scene_nodes}],
    "nodes": nodes,
    "cameras": [{"type": "perspective", "perspective": {"yfov": math.radians(36), "znear": 0.1}}],
    "meshes": meshes,
    "materials": materials,
    "textures": [{"source": 0, "sampler": 0}],
    "samplers": [{"wrapS": 10497, "wrapT": 10497}],
    "images": [{"uri": image}],
    "accessors": accessors,
    "bufferViews": views,
    "buffers": [{"byteLength": len(buffer),
                 "uri": "data:application/octet-stream;base64," + base64.b64encode(bytes(buffer)).decode()}],
}


def rounded(value):
    """Numbers short enough to read."""
    if isinstance(value, float):
        return round(value, 9)
    if isinstance(value, list):
        return [rounded(v) for v in value]
    if isinstance(value, dict):
        return {k: v if k in ("min", "max") else rounded(v) for k, v in value.items()}
    return value


with open(sys.argv[1], "w", encoding="ascii") as file:
    json.dump(rounded(gltf), file, separators=(",", ":"))
    file.write("\n")
