#!/usr/bin/python3
"""Proves that layers.py sees what it is there to see: each forbidden thing alone, in a small tree."""

import pathlib
import tempfile
import unittest

import layers


def problems_of(path, text):
    """What layers.py says of a tree that holds one file."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / path).parent.mkdir(parents=True)
        (root / path).write_text(text, encoding="utf-8")
        problems, file_count = layers.check(root)
        assert file_count == 1
        return problems


class Layers(unittest.TestCase):
    def test_allowed_edges_pass(self):
        text = ('#pragma once\n#include "engine/core/pose.h"\n#include "engine/render/mesh.h"\n'
                "#include <glm/glm.hpp>\n#include <fmt/format.h>\n#include <vector>\n"
                "#include <sys/stat.h>\n")
        self.assertEqual(problems_of("engine/scene/a.h", text), [])

    def test_upward_edge_fails(self):
        self.assertEqual(problems_of("engine/core/a.cpp", '\n#include "engine/scene/scene.h"\n'),
                         ["engine/core/a.cpp:2: core must not include scene"])

    def test_sideways_edge_fails(self):
        self.assertEqual(problems_of("engine/physics/a.h", '#include "engine/render/mesh.h"\n'),
                         ["engine/physics/a.h:1: physics must not include render"])

    def test_engine_never_includes_game(self):
        self.assertEqual(problems_of("engine/app/a.cpp", '#  include "game/rules.h"\n'),
                         ["engine/app/a.cpp:1: the engine never includes the game"])

    def test_foreign_library_fails(self):
        self.assertEqual(problems_of("engine/scene/a.cpp", "#include <btBulletDynamicsCommon.h>\n"),
                         ["engine/scene/a.cpp:1: scene must not include btBulletDynamicsCommon.h; "
                          "it belongs to physics"])

    def test_own_library_in_a_public_header_fails(self):
        text = "#include <GLFW/glfw3.h>\n"
        self.assertEqual(problems_of("engine/platform/a.h", text),
                         ["engine/platform/a.h:1: GLFW/glfw3.h must stay in .cpp files "
                          "and private headers"])
        self.assertEqual(problems_of("engine/platform/a_impl.h", text), [])
        self.assertEqual(problems_of("engine/platform/a.cpp", text), [])

    def test_unknown_library_fails(self):
        self.assertEqual(problems_of("engine/core/a.cpp", "#include <boost/any.hpp>\n"),
                         ["engine/core/a.cpp:1: boost/any.hpp is in no table"])

    def test_private_headers_stay_private(self):
        self.assertEqual(
            problems_of("game/a.cpp", '#include "engine/physics/world/world_state.h"\n'),
            ["game/a.cpp:1: engine/physics/world/world_state.h is private to physics"])

    def test_path_not_from_the_root_fails(self):
        self.assertEqual(
            problems_of("engine/core/a.cpp", '#include "pose.h"\n'),
            ["engine/core/a.cpp:1: includes in quotes begin at the repository's root: "
             "engine/... or game/..."])

    def test_new_module_without_a_row_fails(self):
        self.assertEqual(problems_of("engine/net/a.cpp", '#include "engine/core/pose.h"\n'),
                         ["engine/net/a.cpp:1: module net is not in the table"])

    def test_long_file_fails(self):
        self.assertEqual(problems_of("engine/core/a.cpp", "int a;\n" * layers.LONGEST_FILE), [])
        self.assertEqual(problems_of("engine/core/a.cpp", "int a;\n" * (layers.LONGEST_FILE + 1)),
                         ["engine/core/a.cpp:1: 451 lines; at most 450"])

    def test_empty_tree_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            problems, _ = layers.check(pathlib.Path(folder))
        self.assertEqual(len(problems), 1)


if __name__ == "__main__":
    unittest.main()
