# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/names finds what is defined twice, and lets the rest pass."""

import os
import subprocess
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))


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


if __name__ == "__main__":
    unittest.main()
