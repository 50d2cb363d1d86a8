"""A small windmill whose sails turn: mill.glb, with its animation. Each sail is a node of its own, so
that each collides by itself.

    blender -b --factory-startup -P bl_mill.py -- . MODELS
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bl_house import *  # noqa: E402,F403

HUB = (0, -0.95, 2.1)    # Blender's axes, as of what is on the lathe: z is up, the sails look along -y
SAIL = 1.85              # from the hub's middle: their ends pass a quarter of a metre over the ground
TURN_S, FRAMES_PER_S = 8, 24


def tower():
    m = HouseMesh()
    m.lathe([(0.85, 0), (0.85, 0.25), (0.78, 0.3), (0.55, 2.35)], named("brick"), 12)
    m.lathe([(0.72, 2.3), (0.72, 2.36), (0.35, 2.85), (0, 3.05)], named("roof"), 12)
    m.part((0, 0.55, 0.72), (0.5, 1.1, 0.2), "paintwood", bevel=0.0)
    return m.obj("tower")


def hub():
    m = HouseMesh()
    m.part((0, 0, -0.1), (0.2, 0.2, 0.5), "wood", bevel=0.02)
    return m.obj("hub")


def sail(number):
    """Upright from the hub, turned to its place."""
    m = HouseMesh()
    m.part((0, SAIL / 2, 0), (0.07, SAIL, 0.07), "wood", bevel=0.0)
    m.part((0.17, SAIL / 2 + 0.22, 0), (0.34, SAIL - 0.46, 0.03), "linen", bevel=0.0)
    for y in (0.46, 0.9, 1.34, SAIL - 0.03):
        m.part((0.17, y, 0.02), (0.36, 0.04, 0.03), "wood", bevel=0.0)
    made = m.obj(f"sail_{number + 1}")
    made.rotation_euler = (0, number * math.pi / 2, 0)
    return made


def rotor(parts):
    turning = bpy.data.objects.new("rotor", None)
    bpy.context.scene.collection.objects.link(turning)
    turning.location = HUB
    for part in parts:
        part.parent = turning
    bpy.context.scene.render.fps = FRAMES_PER_S
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 0, TURN_S * FRAMES_PER_S
    for quarter in range(5):
        turning.rotation_euler = (0, quarter * math.pi / 2, 0)
        turning.keyframe_insert("rotation_euler", frame=quarter * TURN_S * FRAMES_PER_S / 4)
    turning.animation_data.action.name = "turn"
    for curve in turning.animation_data.action.fcurves:
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"
    return [turning, *parts]


if __name__ == "__main__":
    reset()
    export([tower(), *rotor([hub(), *(sail(i) for i in range(4))])], "mill", "NONE",
           export_nla_strips=False, export_force_sampling=False)
