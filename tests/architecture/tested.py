#!/usr/bin/python3
"""Every source that decides something has a test: in the mirrored place, or one that includes its header.

tests/engine/x/y_test.cpp is the mirrored place of engine/x/y.cpp; y_gl_test.cpp is as good. A decision is an if, for,
while, switch or question mark outside comments and texts.
"""

import pathlib
import re
import sys

from sizes import blanked
from sources import ROOT, finish, own_files

DECISIONS = 3  # from so many on

# Sources that need none, and why. An entry that is not needed any more fails, so that it goes.
EXEMPT = {}

# Sources that have none yet. This list only gets shorter.
NOT_YET = {
    "engine/app/accuracy/accuracy_copy.cpp",
    "engine/app/accuracy/accuracy_panel.cpp",
    "engine/app/capture/video_file.cpp",
    "engine/app/controls/action_words.cpp",
    "engine/app/controls/live_bindings.cpp",
    "engine/app/controls/random_actions.cpp",
    "engine/app/frame_close.cpp",
    "engine/app/frame_film.cpp",
    "engine/app/frame_output.cpp",
    "engine/app/frame_parts.cpp",
    "engine/app/frame_report.cpp",
    "engine/app/frame_requests.cpp",
    "engine/app/frame_saves.cpp",
    "engine/app/offscreen_run.cpp",
    "engine/app/overlay/animation_bar.cpp",
    "engine/app/overlay/overlay.cpp",
    "engine/app/overlay/overlay_panels.cpp",
    "engine/app/ui/controls_pages.cpp",
    "engine/app/ui/icons.cpp",
    "engine/app/ui/light_page.cpp",
    "engine/app/ui/menu_draw.cpp",
    "engine/app/ui/menu_layout.cpp",
    "engine/app/ui/setting_cells.cpp",
    "engine/app/ui/settings_pages.cpp",
    "engine/assets/asset_images.cpp",
    "engine/assets/foreign/confined_io.cpp",
    "engine/assets/foreign/model_convert.cpp",
    "engine/assets/foreign/model_convert_foreign.cpp",
    "engine/assets/gltf/gltf_animations.cpp",
    "engine/assets/gltf/gltf_buffers.cpp",
    "engine/assets/gltf/gltf_json.cpp",
    "engine/assets/gltf/gltf_meshes.cpp",
    "engine/assets/gltf/gltf_nodes.cpp",
    "engine/assets/image/image_exr.cpp",
    "engine/assets/image/image_jpeg.cpp",
    "engine/assets/image/image_png.cpp",
    "engine/assets/image/image_tga.cpp",
    "engine/assets/mesh_files/obj_materials.cpp",
    "engine/assets/mesh_files/ply_header.cpp",
    "engine/assets/mesh_files/ply_import.cpp",
    "engine/assets/mesh_files/stl_import.cpp",
    "engine/assets/mesh_files/text_words.cpp",
    "engine/assets/model/model_check.cpp",
    "engine/assets/model/model_merge.cpp",
    "engine/assets/model/model_references.cpp",
    "engine/assets/skybox_files.cpp",
    "engine/audio/mixer_voices.cpp",
    "engine/core/text/toml_prescan.cpp",
    "engine/input/action_latch_axes.cpp",
    "engine/input/bindings_built_in.cpp",
    "engine/input/bindings_layer.cpp",
    "engine/input/bindings_print.cpp",
    "engine/input/bindings_sources.cpp",
    "engine/platform/key_names.cpp",
    "engine/platform/physical_keys.cpp",
    "engine/render/frame_light.cpp",
    "engine/render/frame_setup.cpp",
    "engine/render/gl/buffer.cpp",
    "engine/render/gl/debug.cpp",
    "engine/render/gl/framebuffer.cpp",
    "engine/render/gl/pass_timer.cpp",
    "engine/render/gl/program.cpp",
    "engine/render/gl/texture.cpp",
    "engine/render/light/gpu_lights.cpp",
    "engine/render/light/light_setup.cpp",
    "engine/render/passes/drop_pass.cpp",
    "engine/render/passes/light_shadow_pass.cpp",
    "engine/render/passes/scene_light.cpp",
    "engine/render/passes/scene_target.cpp",
    "engine/render/passes/screen/motion_blur_pass.cpp",
    "engine/render/passes/screen/motion_vectors.cpp",
    "engine/render/passes/screen/post_pass.cpp",
    "engine/render/passes/screen/shaft_pass.cpp",
    "engine/render/passes/shadow_pass.cpp",
    "engine/render/passes/sky_pass.cpp",
    "engine/render/quality.cpp",
    "engine/render/renderer_prepare.cpp",
    "engine/render/resources/gpu_meshes.cpp",
    "engine/render/resources/gpu_textures.cpp",
    "engine/render/resources/sampler_setup.cpp",
    "engine/render/sky/atmosphere.cpp",
    "engine/render/sky/gpu_sky.cpp",
    "engine/render/sky/gpu_sky_dome.cpp",
    "game/command_line/camera_text.cpp",
    "game/command_line/command_line.cpp",
    "game/command_line/option_ranges.cpp",
    "game/command_line/parse_error.cpp",
    "game/command_line/shard_option.cpp",
    "game/commands/effects_command.cpp",
    "game/commands/image_study_command.cpp",
    "game/commands/other_commands.cpp",
    "game/commands/play_command.cpp",
    "game/commands/render_command.cpp",
    "game/commands/scene_study_command.cpp",
    "game/commands/scenes_command.cpp",
    "game/commands/shader_worker.cpp",
    "game/commands/simulate_cli.cpp",
    "game/commands/stability_command.cpp",
    "game/commands/study_command.cpp",
    "game/main.cpp",
    "game/main_f64.cpp",
    "game/offscreen/contact_sheet.cpp",
    "game/offscreen/frame_files.cpp",
    "game/offscreen/offscreen_studio.cpp",
    "game/rules/placement.cpp",
    "game/rules/player.cpp",
    "game/rules/rules_archive.cpp",
    "game/rules/rules_forces.cpp",
    "game/rules/rules_viewer.cpp",
    "game/rules/things.cpp",
}

DECISION = re.compile(r"\b(?:if|for|while|switch)\b|\?")
INCLUDE = re.compile(r'^#include "((?:engine|game)/[^"]+)"', re.MULTILINE)


def decisions_in(text):
    return len(DECISION.findall(blanked(text)))


def untested(root):
    """Sources with too many decisions for having no test, and how many sources there are with so many."""
    tests = set(own_files(root, "tests", suffixes=(".cpp", ".h")))
    included = {header for test in tests for header in INCLUDE.findall((root / test).read_text(encoding="utf-8"))}
    without, deciding = set(), 0
    for source in own_files(root, "engine", "game", suffixes=(".cpp",)):
        if decisions_in((root / source).read_text(encoding="utf-8")) < DECISIONS:
            continue
        deciding += 1
        stem = source[:-len(".cpp")]
        is_mirrored = any(f"tests/{stem}{end}" in tests for end in ("_test.cpp", "_gl_test.cpp"))
        if not is_mirrored and f"{stem}.h" not in included:
            without.add(source)
    return without, deciding


def check(root, exempt, not_yet):
    """Every problem in the tree at `root`, and what was looked at in words."""
    without, deciding = untested(root)
    problems = [f"{source}: decides something and has no test: write tests/{source[:-len('.cpp')]}_test.cpp"
                for source in sorted(without - set(exempt) - not_yet)]
    for name, entries in (("EXEMPT", set(exempt)), ("NOT_YET", not_yet)):
        problems += [f"tests/architecture/tested.py: {source} needs no entry any more: strike it off {name}"
                     for source in sorted(entries - without)]
    return problems, f"{deciding} sources with {DECISIONS} decisions or more"


if __name__ == "__main__":
    checked_root = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    finish(*check(checked_root, EXEMPT, NOT_YET))
