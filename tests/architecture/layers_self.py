#!/usr/bin/python3
"""Proves that layers.py sees what it is there to see: each forbidden thing alone, in a small tree."""

import pathlib
import tempfile
import unittest

import layers


def problems_of_tree(texts):
    """What layers.py says of a tree that holds these files."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for path, text in texts.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text, encoding="utf-8")
        return layers.check(root)


def problems_of(path, text):
    """What layers.py says of a tree that holds one file."""
    problems, file_count = problems_of_tree({path: text})
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
        self.assertEqual(problems_of("engine/app/a.cpp", '#  include "game/rules/rules.h"\n'),
                         ["engine/app/a.cpp:1: the engine never includes the game"])

    def test_foreign_library_fails(self):
        self.assertEqual(problems_of("engine/scene/a.cpp", "#include <assimp/scene.h>\n"),
                         ["engine/scene/a.cpp:1: scene must not include assimp/scene.h; "
                          "it belongs to assets"])

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

    def test_tests_of_other_modules_see_public_headers_only(self):
        text = '#include "engine/physics/world/bodies.h"\n'
        self.assertEqual(problems_of_tree({"game/a.cpp": "", "tests/game/a_test.cpp": text})[0],
                         ["tests/game/a_test.cpp:1: engine/physics/world/bodies.h is private to "
                          "physics"])
        self.assertEqual(
            problems_of_tree({"game/a.cpp": "", "tests/engine/physics/a_test.cpp": text})[0], [])

    def test_bullet_stays_in_its_folder(self):
        text = "#include <btBulletDynamicsCommon.h>\n"
        self.assertEqual(problems_of("engine/physics/bullet/a.h", text), [])
        self.assertEqual(problems_of("engine/physics/world/a.cpp", text),
                         ["engine/physics/world/a.cpp:1: btBulletDynamicsCommon.h shows what only "
                          "engine/physics/bullet/ and engine/bullet_world/ may see"])
        self.assertEqual(problems_of("engine/bullet_world/a.h", text), [])

    def test_bullet_is_not_even_named_outside_its_folder(self):
        self.assertEqual(problems_of("engine/physics/world/a.h", "// a btRigidBody\nclass btRigidBody;\n"),
                         ["engine/physics/world/a.h:2: btRigidBody is named outside "
                          "engine/physics/bullet/ and engine/bullet_world/"])
        self.assertEqual(problems_of("engine/physics/bullet/a.h", "class btRigidBody;\n"), [])

    def test_bullet_is_not_seen_through_another_header(self):
        tree = {"engine/physics/bullet/a.h": "#include <LinearMath/btVector3.h>\n",
                "engine/physics/bullet/b.h": '#include "engine/physics/bullet/a.h"\n',
                "engine/physics/bullet/plain.h": "#include <vector>\n",
                "engine/physics/world/c.cpp": '#include "engine/physics/bullet/plain.h"\n'
                                              '#include "engine/physics/bullet/b.h"\n'}
        self.assertEqual(problems_of_tree(tree)[0],
                         ["engine/physics/world/c.cpp:2: engine/physics/bullet/b.h shows what only "
                          "engine/physics/bullet/ and engine/bullet_world/ may see"])

    def test_path_not_from_the_root_fails(self):
        self.assertEqual(
            problems_of("engine/core/a.cpp", '#include "pose.h"\n'),
            ["engine/core/a.cpp:1: includes in quotes begin at the repository's root: "
             "engine/... or game/..."])

    def test_new_module_without_a_row_fails(self):
        self.assertEqual(problems_of("engine/net/a.cpp", '#include "engine/core/pose.h"\n'),
                         ["engine/net/a.cpp:1: module net is not in the table"])

    def test_empty_tree_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            problems, _ = layers.check(pathlib.Path(folder))
        self.assertEqual(len(problems), 1)


if __name__ == "__main__":
    unittest.main()
