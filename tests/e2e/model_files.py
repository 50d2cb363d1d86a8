"""One body in every kind of file that must open: a box of 2 x 3 x 1 m about the origin, each side in
a colour of its own, written by hand as exporters write it. What an image of it must look like is
known: see models.py."""
import base64
import json
import math
import struct
import zlib

HALF_M = (1.0, 1.5, 0.5)
# Side by its outward axis: sRGB bytes, each 0 or 255, which are the same in linear light.
COLORS = {"+x": (0, 255, 0), "-x": (255, 0, 255), "+y": (0, 0, 255), "-y": (255, 255, 255),
          "+z": (255, 0, 0), "-z": (0, 255, 255)}
SIDES = list(COLORS)


def side_corners(side, half=HALF_M):
    """Four corners, counter-clockwise seen from outside."""
    axis, sign = "xyz".index(side[1]), 1 if side[0] == "+" else -1
    b, c = (axis + 1) % 3, (axis + 2) % 3
    corners = []
    for along_b, along_c in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        corner = [0.0, 0.0, 0.0]
        corner[axis], corner[b], corner[c] = sign * half[axis], along_b * half[b], along_c * half[c]
        corners.append(tuple(corner))
    return corners if sign > 0 else corners[::-1]


def normal_of(side):
    normal = [0.0, 0.0, 0.0]
    normal["xyz".index(side[1])] = 1.0 if side[0] == "+" else -1.0
    return tuple(normal)


def z_up(corner):
    """The same place in a file whose +Z is up."""
    return (corner[0], -corner[2], corner[1])


def uv_of(side):
    """Within the side's field of the palette: 3 x 2 fields; v runs down."""
    column, row = SIDES.index(side) % 3, SIDES.index(side) // 3
    return [((column + 0.5 + du) / 3, (row + 0.5 + dv) / 2) for du, dv in ((-.2, .2), (.2, .2), (.2, -.2), (-.2, -.2))]


def palette_png():
    """24 x 16 pixels: six fields of 8 x 8."""
    rows = b""
    for y in range(16):
        rows += b"\0" + b"".join(bytes(COLORS[SIDES[x // 8 + 3 * (y // 8)]]) for x in range(24))

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 24, 16, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Gltf:
    """A glTF file that grows accessor by accessor."""

    def __init__(self):
        self.binary = b""
        self.json = {"asset": {"version": "2.0"}, "bufferViews": [], "accessors": [], "scene": 0,
                     "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": "box"}]}

    def view(self, data):
        self.binary += b"\0" * (-len(self.binary) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)})
        self.binary += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, values, kind, code="f", more=None):
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[kind]
        flat = [number for value in values for number in (value if width > 1 else [value])]
        component = {"f": 5126, "H": 5123, "B": 5121}[code]
        self.json["accessors"].append({"bufferView": self.view(struct.pack(f"<{len(flat)}{code}", *flat)), "type": kind,
                                       "componentType": component, "count": len(flat) // width, **(more or {})})
        return len(self.json["accessors"]) - 1

    def box(self, extra=(), half=HALF_M):
        corners = [corner for side in SIDES for corner in side_corners(side, half)]
        attributes = {"POSITION": self.accessor(corners, "VEC3"),
                      "NORMAL": self.accessor([normal_of(side) for side in SIDES for _ in range(4)], "VEC3")}
        if "uv" in extra:
            attributes["TEXCOORD_0"] = self.accessor([uv for side in SIDES for uv in uv_of(side)], "VEC2")
        if "colors" in extra:
            colors = [(*COLORS[side], 255) for side in SIDES for _ in range(4)]
            attributes["COLOR_0"] = self.accessor(colors, "VEC4", "B", {"normalized": True})
        if "joints" in extra:
            attributes["JOINTS_0"] = self.accessor([(1, 0, 0, 0)] * 24, "VEC4", "H")
            attributes["WEIGHTS_0"] = self.accessor([(1, 0, 0, 0)] * 24, "VEC4")
        indices = [4 * side + k for side in range(6) for k in (0, 1, 2, 0, 2, 3)]
        self.json["meshes"] = [{"primitives": [{"attributes": attributes, "indices": self.accessor(indices, "SCALAR", "H"),
                                                "material": 0}]}]
        self.json["materials"] = [{"name": "paint", "pbrMetallicRoughness": {"metallicFactor": 0}}]

    def paint(self, image):
        self.json["images"], self.json["textures"] = [image], [{"source": 0}]
        self.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}

    def turn_about_y(self, node):
        """Half a turn to the left in one second."""
        times = self.accessor([0.0, 0.5, 1.0], "SCALAR", more={"min": [0], "max": [1]})
        turns = [(0, math.sin(a / 2), 0, math.cos(a / 2)) for a in (0, math.pi / 2, math.pi)]
        self.json["animations"] = [{"name": "turn", "samplers": [{"input": times, "output": self.accessor(turns, "VEC4")}],
                                    "channels": [{"sampler": 0, "target": {"node": node, "path": "rotation"}}]}]

    def glb(self):
        self.json["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(self.json).encode()
        text += b" " * (-len(text) % 4)
        binary = self.binary + b"\0" * (-len(self.binary) % 4)
        return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)) + struct.pack("<I4s", len(text), b"JSON") + text +
                struct.pack("<I4s", len(binary), b"BIN\0") + binary)

    def gltf(self, uri):
        self.json["buffers"] = [{"byteLength": len(self.binary), "uri": uri}]
        return json.dumps(self.json).encode()


def embedded_glb():
    file = Gltf()
    file.box(["uv"])
    file.paint({"mimeType": "image/png", "bufferView": file.view(palette_png())})
    return file.glb()


def colored_glb(half=HALF_M):
    file = Gltf()
    file.box(["colors"], half)
    return file.glb()


def separate_gltf(folder):
    file = Gltf()
    file.box(["uv"])
    file.paint({"uri": "my%20palette.png"})
    (folder / "my palette.png").write_bytes(palette_png())
    (folder / "separate.bin").write_bytes(file.binary)
    return file.gltf("separate.bin")


def inline_gltf():
    file = Gltf()
    file.box(["uv"])
    file.paint({"uri": "data:image/png;base64," + base64.b64encode(palette_png()).decode()})
    return file.gltf("data:application/octet-stream;base64," + base64.b64encode(file.binary).decode())


def animated_glb():
    file = Gltf()
    file.box(["colors"])
    file.turn_about_y(0)
    return file.glb()


def skinned_glb():
    """One joint, child of another, carries all; what the mesh's own node says does not count."""
    file = Gltf()
    file.box(["colors", "joints"])
    # Two metres up and two metres down again: the joint's place at rest is its bind pose.
    joint_from_mesh = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2, 0, 1)
    identity = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)
    file.json["skins"] = [{"joints": [1, 2], "inverseBindMatrices": file.accessor([identity, joint_from_mesh], "MAT4")}]
    file.json["nodes"] = [{"mesh": 0, "skin": 0, "translation": [7, 7, 7]}, {"name": "hip", "children": [2]},
                          {"name": "neck", "translation": [0, 2, 0]}]
    file.json["scenes"] = [{"nodes": [0, 1]}]
    file.turn_about_y(2)
    return file.glb()


def obj(materials=None):
    text = "# by hand\n" + (f"mtllib {materials}\nusemtl paint\n" if materials else "")
    for side in SIDES:
        text += "".join("v %g %g %g\n" % corner for corner in side_corners(side))
        text += "".join("vt %.6f %.6f\n" % (u, 1 - v) for u, v in uv_of(side))
    for i in range(6):
        text += "f " + " ".join(f"{4 * i + k}/{4 * i + k}" for k in (1, 2, 3, 4)) + "\n"
    return text.encode()


def mtl(image):
    return f"newmtl paint\nKd 1 1 1\nillum 1\nmap_Kd {image}\n".encode()


def ply(binary):
    head = "ply\nformat %s 1.0\nelement vertex 24\nproperty float x\nproperty float y\nproperty float z\n" % (
        "binary_little_endian" if binary else "ascii")
    head += "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n"
    body = b""
    for side in SIDES:
        for corner in side_corners(side):
            values = (*z_up(corner), *COLORS[side])
            body += struct.pack("<fffBBB", *values) if binary else b"%g %g %g %d %d %d\n" % values
    for i in range(6):
        corners = [4 * i + k for k in range(4)]
        body += struct.pack("<B4i", 4, *corners) if binary else b"4 %d %d %d %d\n" % tuple(corners)
    return head.encode() + body


def stl(binary):
    triangles = []
    for side in SIDES:
        a, b, c, d = (z_up(corner) for corner in side_corners(side))
        triangles += [(a, b, c), (a, c, d)]
    if binary:
        return bytes(80) + struct.pack("<I", 12) + b"".join(
            struct.pack("<12fH", 0, 0, 0, *(number for corner in triangle for number in corner), 0) for triangle in triangles)
    text = "solid box\n"
    for triangle in triangles:
        text += "facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % corner for corner in triangle) + "endloop\nendfacet\n"
    return (text + "endsolid box\n").encode()


def dae():
    """In centimetres, +Z up, a material a side."""
    numbers = " ".join("%g" % (100 * number) for side in SIDES for corner in side_corners(side) for number in z_up(corner))
    effects = materials = binds = faces = ""
    for i, side in enumerate(SIDES):
        color = " ".join("%g" % (byte / 255) for byte in COLORS[side])
        effects += (f'<effect id="fx{i}"><profile_COMMON><technique sid="common"><lambert><diffuse><color>{color} 1</color></diffuse>'
                    '</lambert></technique></profile_COMMON></effect>')
        materials += f'<material id="m{i}" name="side{i}"><instance_effect url="#fx{i}"/></material>'
        binds += f'<instance_material symbol="s{i}" target="#m{i}"/>'
        corners = " ".join(str(4 * i + k) for k in (0, 1, 2, 0, 2, 3))
        faces += f'<triangles count="2" material="s{i}"><input semantic="VERTEX" source="#v" offset="0"/><p>{corners}</p></triangles>'
    return f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_effects>{effects}</library_effects><library_materials>{materials}</library_materials>
<library_geometries><geometry id="g" name="box"><mesh><source id="p"><float_array id="pa" count="72">{numbers}</float_array>
<technique_common><accessor source="#pa" count="24" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>{faces}</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="box"><instance_geometry url="#g"><bind_material><technique_common>
{binds}</technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
""".encode()


def fbx():
    """FBX as text, in centimetres, +Y up, a material a side."""
    vertices = ",".join("%g" % (100 * number) for side in SIDES for corner in side_corners(side) for number in corner)
    corners = ",".join(f"{4 * i},{4 * i + 1},{4 * i + 2},{-4 * i - 4}" for i in range(6))  # the last one: -1 - index
    materials = connections = ""
    for i, side in enumerate(SIDES):
        color = ",".join("%g" % (byte / 255) for byte in COLORS[side])
        materials += (f'Material: {300 + i}, "Material::side{i}", "" {{\n Version: 102\n ShadingModel: "lambert"\n Properties70: {{\n'
                      f'  P: "DiffuseColor", "Color", "", "A",{color}\n  P: "DiffuseFactor", "Number", "", "A",1\n }}\n}}\n')
        connections += f' C: "OO",{300 + i},200\n'
    return f"""; FBX 7.4.0 project file
FBXHeaderExtension:  {{
 FBXHeaderVersion: 1003
 FBXVersion: 7400
}}
GlobalSettings:  {{
 Version: 1000
 Properties70:  {{
  P: "UpAxis", "int", "Integer", "",1
  P: "UpAxisSign", "int", "Integer", "",1
  P: "FrontAxis", "int", "Integer", "",2
  P: "FrontAxisSign", "int", "Integer", "",1
  P: "CoordAxis", "int", "Integer", "",0
  P: "CoordAxisSign", "int", "Integer", "",1
  P: "UnitScaleFactor", "double", "Number", "",1
 }}
}}
Objects:  {{
Geometry: 100, "Geometry::box", "Mesh" {{
 Vertices: *72 {{
  a: {vertices}
 }}
 PolygonVertexIndex: *24 {{
  a: {corners}
 }}
 GeometryVersion: 124
 LayerElementMaterial: 0 {{
  Version: 101
  Name: ""
  MappingInformationType: "ByPolygon"
  ReferenceInformationType: "IndexToDirect"
  Materials: *6 {{
   a: 0,1,2,3,4,5
  }}
 }}
 Layer: 0 {{
  Version: 100
  LayerElement:  {{
   Type: "LayerElementMaterial"
   TypedIndex: 0
  }}
 }}
}}
Model: 200, "Model::box", "Mesh" {{
 Version: 232
}}
{materials}}}
Connections:  {{
 C: "OO",200,0
 C: "OO",100,200
{connections}}}
""".encode()


def write_all(folder):
    """Every kind; gives name by name whether it has colours."""
    (folder / "paint.png").write_bytes(palette_png())
    (folder / "textured.mtl").write_bytes(mtl("paint.png"))
    files = {"embedded.glb": embedded_glb(), "colored.glb": colored_glb(), "separate.gltf": separate_gltf(folder),
             "inline.gltf": inline_gltf(), "animated.glb": animated_glb(), "skinned.glb": skinned_glb(),
             "textured.obj": obj("textured.mtl"), "plain.obj": obj(), "ascii.ply": ply(False), "binary.ply": ply(True),
             "ascii.stl": stl(False), "binary.stl": stl(True), "box.dae": dae(), "box.fbx": fbx()}
    for name, data in files.items():
        (folder / name).write_bytes(data)
    return {name: name not in ("plain.obj", "ascii.stl", "binary.stl") for name in files}
