# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""tests/unsteady.txt stays short, names classes that exist, and of the core only those of servo loops and processes.

usage: unsteady_test.py BUILD_FOLDER
"""

import glob
import json
import os
import subprocess
import sys
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
MOST = 39  # lower it with each class that leaves the list
BUILD = sys.argv.pop() if len(sys.argv) > 1 else os.path.join(ROOT, "build", "dev")


def rows():
    with open(os.path.join(ROOT, "tests", "unsteady.txt"), encoding="utf-8") as stream:
        return [line.rstrip("\n") for line in stream if not line.startswith("#")]


class UnsteadyTest(unittest.TestCase):
    def test_form(self):
        for row in rows():
            self.assertRegex(row, r"^\w+ +\w.{10,}$", "a class and its reason")
        names = [row.split()[0] for row in rows()]
        self.assertEqual(names, sorted(set(names)))
        self.assertLessEqual(len(names), MOST)

    def test_classes_exist(self):
        command = ["ctest", "--test-dir", BUILD, "--show-only=json-v1"]
        listed = json.loads(subprocess.run(command, capture_output=True, check=True).stdout)["tests"]
        self.assertEqual({row.split()[0] for row in rows()} - {test["name"] for test in listed}, set())

    def test_core(self):
        for path in glob.glob(os.path.join(ROOT, "tests", "core", "**", "*.cpp"), recursive=True):
            name = os.path.basename(path).removesuffix(".cpp")
            if any(row.split()[0] == name for row in rows()):
                self.assertRegex(os.path.relpath(path, ROOT), r"^tests/core/(haptics/servo|process)/")


if __name__ == "__main__":
    unittest.main()
