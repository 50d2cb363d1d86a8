#!/usr/bin/env python3
"""Writes assets/scenes/hard/*.toml, the gallery of hard cases, and assets/models/hard/*.obj.

    python3 assets/source/make_hard_scenes.py
"""
import pathlib

import hard_contacts
import hard_joints
import hard_motion
import hard_stacks

ASSETS = pathlib.Path(__file__).resolve().parent.parent


def main():
    models = ASSETS / "models" / "hard"
    folder = ASSETS / "scenes" / "hard"
    for made in (models, folder):
        made.mkdir(parents=True, exist_ok=True)
    hard_contacts.write_models(models)
    for part in (hard_stacks, hard_joints, hard_contacts, hard_motion):
        for scene in part.scenes():
            scene.write(folder)


if __name__ == "__main__":
    main()
