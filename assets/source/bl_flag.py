# flagpole with its flag; the cloth has wind weights. blender -b --factory-startup -P bl_flag.py -- . MODELS
import os, sys; sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bl_common import *
HEIGHT, RADIUS, KNOB = 5.2, .04, .075               # metres; make_garden.py's body stands as high
LONG, WIDE, COLUMNS, ROWS = 1.5, .95, 18, 6
BANDS = [(.025, .07, .22), (.82, .62, .20), (.025, .07, .22)]


def vertex_colored(name, verts, faces, colors, material, weights=None):
    me = bpy.data.meshes.new(name); me.from_pydata(verts, [], faces); me.materials.append(material)
    col = me.color_attributes.new('Col', 'FLOAT_COLOR', 'POINT')
    for i, c in enumerate(colors): col.data[i].color = (*c, 1)
    if weights: wind(me, weights)
    for p in me.polygons: p.use_smooth = True
    o = bpy.data.objects.new(name, me); bpy.context.scene.collection.objects.link(o); return o


def cloth():
    """Streams along +X from the pole. Waves run outwards: the phase falls along it."""
    v, f, c, w = [], [], [], []
    for band, color in enumerate(BANDS):            # bands share no vertices, so that colours end sharply
        rows = ROWS // len(BANDS)
        first = len(v)
        for k in range(rows + 1):
            for i in range(COLUMNS + 1):
                u, t = i / COLUMNS, (band * rows + k) / ROWS
                v.append((RADIUS + LONG * u, .10 * u * math.sin(5 * u), HEIGHT - .12 - WIDE * t - .14 * u * u)); c.append(color)
                w.append((0, (-.42 * u + .06 * t) % 1, u ** .5))
        for k in range(rows):
            for i in range(COLUMNS):
                a = first + k * (COLUMNS + 1) + i; f.append((a, a + COLUMNS + 1, a + COLUMNS + 2, a + 1))
    return vertex_colored('flag', v, f, c, vcol('vcol_plant', two=True), w)


def vcol(name, two):
    m = bpy.data.materials.new(name); m.use_nodes = True; b = m.node_tree.nodes['Principled BSDF']; b.inputs['Roughness'].default_value = .7
    n = m.node_tree.nodes.new('ShaderNodeVertexColor'); n.layer_name = 'Col'; m.node_tree.links.new(n.outputs[0], b.inputs['Base Color']); m.use_backface_culling = not two; return m


def pole():
    m = Mesh(); S = flat('paint_white', (.75, .73, .68), .5)
    m.lathe([(RADIUS * 1.5, 0), (RADIUS * 1.5, .1), (RADIUS, .14), (RADIUS * .7, HEIGHT)], S, 12)
    m.lathe([(0, HEIGHT), (KNOB * .8, HEIGHT + .03), (KNOB, HEIGHT + .07), (KNOB * .7, HEIGHT + .13), (0, HEIGHT + .15)], S, 12)
    return m.obj('flagpole')


reset(); export([pole()], 'flagpole', 'NONE'); export([cloth()], 'flag', 'NONE', export_attributes=True)
