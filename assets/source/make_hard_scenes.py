#!/usr/bin/env python3
"""Writes assets/scenes/hard/*.toml, the gallery of hard cases, their models and docs/GALLERY.md.

    python3 assets/source/make_hard_scenes.py
"""
import pathlib

import hard_contacts
import hard_driven
import hard_effects
import hard_fields
import hard_hulls
import hard_joints
import hard_motion
import hard_page
import hard_rounds
import hard_stacks

ASSETS = pathlib.Path(__file__).resolve().parent.parent


def main():
    models = ASSETS / "models" / "hard"
    folder = ASSETS / "scenes" / "hard"
    docs = ASSETS.parent / "docs"
    for made in (models, folder, docs):
        made.mkdir(parents=True, exist_ok=True)
    for part in (hard_contacts, hard_hulls, hard_rounds, hard_driven):
        part.write_models(models)
    scenes = [scene for part in (hard_stacks, hard_joints, hard_contacts, hard_motion, hard_hulls, hard_rounds,
                                 hard_driven, hard_effects, hard_fields)
              for scene in part.scenes()]
    for scene in scenes:
        scene.known_red = hard_page.KNOWN_RED.get(scene.id, ())
        scene.write(folder)
    scenes.sort(key=lambda scene: (scene.id[0] != "H", scene.id))
    (docs / "GALLERY.md").write_text(hard_page.page(scenes), encoding="utf-8")


if __name__ == "__main__":
    main()
