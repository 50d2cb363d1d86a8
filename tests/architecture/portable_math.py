#!/usr/bin/python3
"""What feeds the simulation's state calls no elementary function of the C library: their last bit depends on the
processor and on the library's version. engine/core/portable_math.h has the same functions with the same bits everywhere.

In the folders below every std::sin and its kin, also by way of glm, is a problem, but in the files that are only seen or
heard. Square roots, remainders and roundings are exact by IEEE 754 and free.
"""

import re
import sys
import pathlib

from sources import ROOT, finish, own_files

FOLDERS = ("engine/core", "engine/ecs", "engine/assets", "engine/physics", "engine/scene", "engine/effects", "game/rules")
# Seen or heard only: nothing of it comes back to the simulation.
EXEMPT = {
    "engine/assets/gltf/gltf_meshes.cpp": "texture coordinates",
    "engine/assets/mesh_data.cpp": "normals",
    "engine/assets/mesh_files/obj_materials.cpp": "materials",
    "engine/assets/mesh_files/ply_import.cpp": "colours",
    "engine/assets/primitives.cpp": "meshes that are drawn; bodies have shapes of their own",
    "engine/core/color.h": "colours",
    "engine/effects/nature/flock.cpp": "birds, which touch nothing",
    "engine/effects/nature/grass.cpp": "drawn",
    "engine/effects/nature/grass_tufts.cpp": "drawn",
    "engine/effects/screen/motion_blur.cpp": "drawn",
    "engine/effects/screen/viewer_aids.cpp": "drawn",
    "engine/effects/sound/acoustics.cpp": "heard",
    "engine/effects/sound/ambient_sounds.cpp": "heard",
    "engine/effects/sound/creak_sounds.cpp": "heard",
    "engine/effects/sound/impact_sounds.cpp": "heard",
    "engine/effects/sound/rolling_sounds.cpp": "heard",
    "engine/effects/sound/room_probe.cpp": "heard",
    "engine/effects/sound/room_reverb.cpp": "heard",
    "engine/effects/sound/sound_obstacles.cpp": "heard",
    "engine/effects/sound/sound_paths.cpp": "heard",
    "engine/effects/sound/wind_sound.cpp": "heard",
}

NAMES = ("sin|cos|tan|sincos|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|expm1|log|log2|log10|log1p|"
         "pow|cbrt|hypot|erf|erfc|tgamma|lgamma")
CALL = re.compile(rf"(?:\bstd::|\bglm::|(?<![\w:.>])::)(?:{NAMES}|angleAxis|slerp|rotate|rotation|eulerAngles|pitch|yaw|roll|"
                  rf"angle|mix_angles)[fl]?\(|(?<![\w:.>])(?:{NAMES})[fl]?\(")
COMMENT = re.compile(r"//.*")
TEXT = re.compile(r'"(?:[^"\\]|\\.)*"')


def calls_in(path):
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        found = CALL.search(COMMENT.sub("", TEXT.sub("", line)))
        if found:
            yield number, found.group(0)


def check(root, exempt):
    problems = []
    files = own_files(root, *FOLDERS, suffixes=(".cpp", ".h"))
    for path in files:
        found = list(calls_in(root / path))
        if path in exempt:
            if not found:
                problems.append(f"tests/architecture/portable_math.py: {path} needs no entry any more: strike it off EXEMPT")
            continue
        problems += [f"{path}:{number}: {call}…) differs between processors: take portable_math.h's" for number, call in found]
    problems += [f"tests/architecture/portable_math.py: there is no {path}" for path in sorted(set(exempt) - set(files))]
    return problems, f"elementary functions in {len(files)} files"


if __name__ == "__main__":
    checked_root = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    finish(*check(checked_root, EXEMPT))
