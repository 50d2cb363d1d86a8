#!/usr/bin/python3
"""Proves that sizes.py counts what a reader would count, and breaks at each limit and not before: in small trees."""

import pathlib
import tempfile
import unittest

import sizes


def problems_of(texts, exempt=frozenset()):
    """What sizes.py says of a tree that holds these files."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for path, text in texts.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text, encoding="utf-8")
        return sizes.check(root, set(exempt))[0]


def function_of(lines, name="f"):
    return f"void {name}() {{\n" + "    g();\n" * (lines - 2) + "}\n"


def type_of(members, kind="struct", above=""):
    return f"{above}{kind} Thing {{\n" + "".join(f"    {member}\n" for member in members) + "};\n"


class Sizes(unittest.TestCase):
    def test_folders(self):
        full = {f"engine/core/a{i}.h": "" for i in range(sizes.FOLDER)}
        self.assertEqual(problems_of(full), [])
        self.assertEqual(problems_of({**full, "engine/core/text/b.h": "", "engine/core/CMakeLists.txt": ""}), [])
        self.assertEqual(problems_of({**full, "engine/core/b.h": ""}), ["engine/core: 26 sources; at most 25"])

    def test_files(self):
        for path in ("engine/core/a.cpp", "tests/engine/core/a_test.cpp"):
            self.assertEqual(problems_of({path: "int a;\n" * 400}), [])
            self.assertEqual(problems_of({path: "int a;\n" * 401}), [f"{path}:1: 401 lines; at most 400"])

    def test_functions(self):
        small = "".join(function_of(3, f"g{i}") for i in range(20))
        self.assertEqual(problems_of({"game/a.cpp": small + function_of(60)}), [])
        self.assertEqual(problems_of({"game/a.cpp": small + function_of(61)}),
                         ["game/a.cpp:61: f has 61 lines; at most 60"])
        self.assertEqual(problems_of({"game/a.cpp": small + "Thing::Thing(int a)\n    : a_{a}, b_{0},\n      c_(a) "
                                      + "{\n" + "    g();\n" * 60 + "}\n"}),
                         ["game/a.cpp:61: Thing::Thing has 64 lines; at most 60"])

    def test_the_usual_function(self):
        self.assertEqual(problems_of({"game/a.cpp": function_of(7, "a") + function_of(7, "b")}), [])
        self.assertEqual(problems_of({"game/a.cpp": function_of(8, "a") + function_of(8, "b")}),
                         ["functions have 8 lines in the median and 8 at the 90th percentile; at most 7 and 25"])
        many = "".join(function_of(3, f"g{i}") for i in range(8)) + "".join(function_of(26, f"h{i}") for i in range(3))
        self.assertEqual(problems_of({"game/a.cpp": many}),
                         ["functions have 3 lines in the median and 26 at the 90th percentile; at most 7 and 25"])

    def test_public_functions(self):
        functions = [f"int f{i}(int a = g(), std::function<void()> b = {{}}) const;" for i in range(25)]
        silent = ["Thing();", "~Thing();", "Thing(const Thing&) = delete;", "Thing& operator=(const Thing&) = delete;",
                  "friend bool operator==(const Thing&, const Thing&) = default;", "using F = void(int);",
                  "static constexpr int kMost = g();", "enum class Kind { A, B };", "int values[3]{1, 2, 3};",
                  "// int f();", 'const char* text{"int f();"};']
        within = ["public:", *silent, *functions, "private:", "void hidden();"]
        self.assertEqual(problems_of({"game/a.h": type_of(within, "class")}), [])
        self.assertEqual(problems_of({"game/a.h": type_of(["public:", "int one_more() { return 1; }", *within], "class")}),
                         ["game/a.h:1: Thing has 26 public functions; at most 25"])
        self.assertEqual(problems_of({"game/a.h": type_of(["int one_more();", *functions])}),
                         ["game/a.h:1: Thing has 26 public functions; at most 25"])

    def test_fields(self):
        fields = ["int a{0}, b{1};", "std::map<int, int> c;", "std::function<void(int, int)> d;",
                  *(f"double x{i}{{0}};" for i in range(16))]
        self.assertEqual(problems_of({"game/a.h": type_of(fields)}), [])
        with_function = ["std::optional<std::array<Real, 2>> y{};", *fields, "private:", "int count() const;"]
        self.assertEqual(problems_of({"game/a.h": type_of(with_function)}),
                         ["game/a.h:1: Thing has 21 fields; at most 20"])

    def test_plain_data_may_have_more_fields(self):
        fields = [f"double x{i}{{0}};" for i in range(40)]
        self.assertEqual(problems_of({"game/a.h": type_of(fields)}), [])
        self.assertEqual(problems_of({"game/a.h": type_of(["int y;", *fields])}),
                         ["game/a.h:1: Thing has 41 fields; at most 40"])

    def test_what_stands_in_functions_and_nested_types_is_their_own(self):
        nested = type_of(["struct In {", *(f"    int y{i};" for i in range(20)), "};", *(f"int x{i};" for i in range(20)),
                          "void f() {", *(f"    int z{i} = g();" for i in range(5)), "}"])
        self.assertEqual(problems_of({"game/a.h": nested}), [])

    def test_exempt(self):
        long = {"game/a.cpp": "int a;\n" * 401}
        self.assertEqual(problems_of(long, {"a.cpp"}), [])
        self.assertEqual(problems_of({"game/a.cpp": "int a;\n"}, {"a.cpp"}),
                         ["tests/architecture/sizes.py: a.cpp is no longer too large: strike it off EXEMPT"])


if __name__ == "__main__":
    unittest.main()
