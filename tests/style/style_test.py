# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/style finds each thing that it looks for, and nothing in a clean file."""

import os
import subprocess
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
HEAD = "// SPDX-FileCopyrightText: 2026 The Handwheel developers\n// SPDX-License-Identifier: GPL-3.0-or-later\n"


class StyleTest(unittest.TestCase):
    def run_on(self, name, text):
        return self.run_on_files({name: text})

    def run_on_files(self, files):
        with tempfile.TemporaryDirectory() as root:
            with open(os.path.join(ROOT, ".clang-format"), encoding="utf-8") as rules:
                with open(os.path.join(root, ".clang-format"), "w", encoding="utf-8") as copy:
                    copy.write(rules.read())
            for name, text in files.items():
                path = os.path.join(root, name)
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8", newline="") as stream:
                    stream.write(text)
            run = subprocess.run([os.path.join(ROOT, "tools", "style"), root], capture_output=True, text=True)
            return run.returncode, run.stdout

    def assert_finds(self, name, text, place, what):
        code, output = self.run_on(name, text)
        self.assertEqual(code, 1, output)
        self.assertIn(f"{name}:{place}: ", output)
        self.assertIn(what, output)

    def test_clean(self):
        self.assertEqual(self.run_on("Wheel.h", HEAD + "#pragma once\n\nint spokes();\n")[0], 0)
        self.assertEqual(self.run_on("Wheel.cpp", HEAD + "int spokes = 5;\n")[0], 0)

    def test_licence_header(self):
        self.assert_finds("Wheel.cpp", "int spokes = 5;\n", 1, "SPDX-License-Identifier")
        self.assert_finds("turn.py", "print(5)\n", 1, "SPDX-FileCopyrightText")
        self.assert_finds("turn", "#!/bin/sh\ntrue\n", 1, "SPDX-FileCopyrightText")

    def test_pragma_once(self):
        self.assert_finds("Wheel.h", HEAD + "\nint spokes();\n", 3, "#pragma once")

    def test_first_sentence(self):
        words = " ".join(["spoke"] * 15)
        clean = f"// {words}. Then units, and\n// {words}.\n\nint spokes();\n"
        self.assertEqual(self.run_on("Wheel.h", HEAD + "#pragma once\n\n" + clean)[0], 0)
        long = f"// {words}\n// and rim. Then units.\nint spokes();\n"
        self.assert_finds("Wheel.h", HEAD + "#pragma once\n\n" + long, 5, "17 words")
        named = f"// A rim.\nstruct Rim;\n\n// {words} rim.\nclass Wheel {{}};\n"
        self.assert_finds("Wheel.h", HEAD + "#pragma once\n\n" + named, 8, "16 words")
        self.assertEqual(self.run_on("Hub.h", HEAD + "#pragma once\n\n" + named)[0], 0)

    def test_openings(self):
        for comment in ("Of both.", "That it turns.", "as it was", "What a turn leaves.", "whether it turns"):
            self.assert_finds("Wheel.cpp", HEAD + f"\n// {comment}\nint spokes;\n", 4, comment.split()[0])
            self.assert_finds("Wheel.cpp", HEAD + f"int rim;\nint spokes;  // {comment}\n", 4, comment.split()[0])
        for text in ("// Returns true if\n// what turns is a wheel.\nint spokes;\n", "int spokes;  // thatched ones\n",
                     'const char* kText = "// of both";\n', "// Offset, mm.\nint spokes;\n"):
            self.assertEqual(self.run_on("Wheel.cpp", HEAD + "\n" + text), (0, "1 C++ files and everything around them are in style\n"))

    def test_private_words(self):
        for name in ("place", "m_places", "kWay", "placeOf", "RimPlace", "Ways", "shortestWay", "wayBetween"):
            self.assert_finds("Wheel.cpp", HEAD + f"int rim;\nint {name} = 5;\n", 4, name)
        for text in ("void place();", "int placeWheel;", "int m_isUnderWay;", "int inTheWay;", "int replace;", "int away;", "int placement;",
                     "int sideways;", 'const char* kText = "place";', "int spokes;  // verb: to place"):
            self.assertEqual(self.run_on("Wheel.cpp", HEAD + text + "\n")[0], 0, text)

    def test_pages(self):
        self.assertEqual(self.run_on_files({"docs/a.md": "[b](b.md#part), [c](https://c.org), ![d](../d.png)\n", "docs/b.md": "b\n", "d.png": ""})[0], 0)
        self.assert_finds("docs/a.md", "a\n[b](b.md)\n", 2, "b.md")
        self.assertEqual(self.run_on("README.md", "word " * 600 + "\n")[0], 0)
        self.assert_finds("README.md", "word " * 601 + "\n", 1, "601 words")

    def test_format(self):
        self.assert_finds("Wheel.cpp", HEAD + "int spokes=5;\n", 3, "clang-format")

    def test_whitespace(self):
        self.assert_finds("Wheel.cpp", HEAD + "int a; \n", 3, "blanks")
        self.assert_finds("Wheel.cpp", HEAD + "\tint a;\n", 3, "tab")
        self.assert_finds("Wheel.cpp", HEAD + "int a;\r\n", 3, "carriage return")
        self.assert_finds("Wheel.cpp", HEAD + "int a;", 3, "no end")

    def test_unfinished(self):
        self.assert_finds("Wheel.cpp", HEAD + "// TO" + "DO: the spokes\n", 3, "unfinished")

    def test_length(self):
        code, output = self.run_on("Wheel.cpp", HEAD + "int a;\n" * 299)
        self.assertEqual(code, 0, output)
        self.assertIn("warning: Wheel.cpp:301", output)
        self.assert_finds("Wheel.cpp", HEAD + "int a;\n" * 499, 501, "501 lines")

    def test_folder(self):
        def wheels(count):
            return {f"wheels/Wheel{i}.cpp": HEAD + "int spokes = 5;\n" for i in range(count)}

        self.assertEqual(self.run_on_files(wheels(45))[0], 0)
        code, output = self.run_on_files(wheels(46))
        self.assertEqual(code, 1, output)
        self.assertIn("wheels: 46 sources", output)


if __name__ == "__main__":
    unittest.main()
