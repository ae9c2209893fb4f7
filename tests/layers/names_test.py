# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/names finds what is defined twice, and lets the rest pass."""

import os
import subprocess
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
ROOM = "handwheel_room(room\n  SOURCES\n    One.cpp\n    Other.cpp)"


class NamesTest(unittest.TestCase):
    def run_on(self, **files):
        with tempfile.TemporaryDirectory() as root:
            for name, text in files.items():
                path = os.path.join(root, "core" if name < "M" else "app", name + ".h")
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8") as stream:
                    stream.write(text)
            run = subprocess.run([os.path.join(ROOT, "tools", "names"), root], capture_output=True, text=True)
            return run.returncode, run.stdout

    def test_twice(self):
        for line in ("struct Job {\n};\n", "class Job : public Base {\n};\n", "enum class Job { A, B };\n",
                     "inline constexpr int kJob = 1;\n"):
            code, output = self.run_on(A=f"namespace handwheel {{\n{line}}}\n", Z=f"namespace handwheel {{\n{line}}}\n")
            self.assertEqual(code, 1, line)
            self.assertIn("core/A.h:2, too", output)

    def test_own(self):
        for one, other in (("class Job;\n", "class Job {\n};\n"),
                           ("namespace {\nstruct Job {\n};\n}  // namespace\n", "struct Job {\n};\n"),
                           ("struct Outer::Job {\n};\n", "struct Job {\n};\n"),
                           ("}\nnamespace handwheel::other {\nstruct Job {\n};\n", "struct Job {\n};\n"),
                           ("struct A {\n  struct Job {\n  };\n};\n", "struct Job {\n};\n")):
            code, output = self.run_on(A=f"namespace handwheel {{\n{one}}}\n", Z=f"namespace handwheel {{\n{other}}}\n")
            self.assertEqual(code, 0, output)

    def run_on_target(self, one, other, folder="core/room", command=ROOM):
        with tempfile.TemporaryDirectory() as root:
            os.makedirs(os.path.join(root, folder))
            for name, text in (("CMakeLists.txt", command + "\n"), ("One.cpp", one), ("Other.cpp", other)):
                with open(os.path.join(root, folder, name), "w", encoding="utf-8") as stream:
                    stream.write(text)
            run = subprocess.run([os.path.join(ROOT, "tools", "names"), root], capture_output=True, text=True)
            return run.returncode, run.stdout

    @staticmethod
    def unnamed(text):
        return f"namespace handwheel {{\nnamespace {{\n\n{text}\n}}  // namespace\n}}  // namespace handwheel\n"

    CLASHES = (
        ("constexpr double kGap = 1.0;  // mm\n", "constexpr int kLeast = 1, kGap = 2;\n"),
        ("bool isOn(const Vec3& place) {\n}\n", "bool isOn(Vec3 p) {\n}\n"),
        ("bool isOn(double a, double tolerance = 1e-9) {\n}\n", "int isOn(double b,\n         double c) {\n}\n"),
        ("struct Cell {\n};\n", "using Cell = int;\n"),
        ("using Cell = std::pair<int, int>;\n", "using Cell = int;\n"),
        ("int side() {\n}\n", "constexpr int side = 1;\n"),
        ("constexpr int kLeast = 1,\n              kMost = 2;\n", "int f() {\n  constexpr int kMost = 3;\n}\n"),
    )
    NO_CLASHES = (
        ("using Json = nlohmann::json;\n", "using Json = nlohmann::json;  // of files\n"),
        ("bool isOn(const Vec3& place) {\n}\n", "bool isOn(double place) {\n}\n"),
        ("bool isOn(Vec3& place) {\n}\n", "bool isOn(const Vec3* place) {\n}\n"),
        ("bool isOn(int a) {\n}\n", "bool isOn(int a, int b) {\n}\n"),
        ("void draw() {\n  constexpr double kGap = 1.0;\n}\n", "constexpr double kGap = 1.0;\n"),
    )

    def test_one_target(self):
        for one, other in self.CLASHES:
            code, output = self.run_on_target(self.unnamed(one), self.unnamed(other))
            self.assertEqual(code, 1, one + other)
            self.assertIn("is in core/room/One.cpp:4, too", output)
        for one, other in self.NO_CLASHES:
            code, output = self.run_on_target(self.unnamed(one), self.unnamed(other))
            self.assertEqual(code, 0, output)

    def test_other_targets(self):
        same = self.unnamed("constexpr double kGap = 1.0;\n")
        for command in ("handwheel_room(one\n  SOURCES One.cpp)\nhandwheel_room(other\n  SOURCES Other.cpp)",
                        "handwheel_room(room\n  SOURCES One.cpp Other.cpp)\n"
                        "set_source_files_properties(Other.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)"):
            code, output = self.run_on_target(same, same, command=command)
            self.assertEqual(code, 0, output)

    def test_tests_of_a_folder(self):
        code, output = self.run_on_target(
            "using Json = nlohmann::json;\n", "using Json = QJsonObject;\n", folder="tests/room",
            command="handwheel_tests(CLASSES One ROOMS base)\nhandwheel_tests(DRAW\n  CLASSES\n    Other)")
        self.assertEqual(code, 1)
        self.assertIn("tests/room/Other.cpp:1: Json is in tests/room/One.cpp:1, too", output)


if __name__ == "__main__":
    unittest.main()
