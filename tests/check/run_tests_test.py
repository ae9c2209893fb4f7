# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/run-tests runs a listed class again after failed comparisons, and nothing else."""

import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
PRESETS = """{"version": 6,
  "configurePresets": [{"name": "p", "generator": "Ninja", "binaryDir": "${sourceDir}/build"}],
  "testPresets": [{"name": "p", "configurePreset": "p", "output": {"outputOnFailure": true}}]}"""
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(p NONE)
enable_testing()
add_test(NAME A COMMAND sh ${CMAKE_SOURCE_DIR}/a)
set_tests_properties(A PROPERTIES TIMEOUT 2 SKIP_REGULAR_EXPRESSION "HANDWHEEL_DATA is not set")
"""
COMPARED = "echo 'Totals: 3 passed, 1 failed, 0 skipped'; exit 1"
FIRST_TIME_ONLY = f"[ $runs -gt 1 ] || {{ {COMPARED}; }}"


class RunTestsTest(unittest.TestCase):
    def run_on(self, script, listed=True, test="sh ${CMAKE_SOURCE_DIR}/a"):
        """(exit code, closing lines, how often the test was run) of a project with one test."""
        with tempfile.TemporaryDirectory() as root:
            files = {"CMakePresets.json": PRESETS, "CMakeLists.txt": PROJECT.replace("sh ${CMAKE_SOURCE_DIR}/a", test),
                     "a": f"echo x >> {root}/runs\nruns=$(wc -l < {root}/runs)\n{script}\n",
                     "tests/unsteady.txt": "# Comment.\nA waits for the window\n" if listed else "B waits for a clock\n"}
            for name, text in files.items():
                os.makedirs(os.path.dirname(os.path.join(root, name)), exist_ok=True)
                with open(os.path.join(root, name), "w", encoding="utf-8") as stream:
                    stream.write(text)
            subprocess.run(["cmake", "--preset", "p"], cwd=root, check=True, capture_output=True)
            run = subprocess.run([os.path.join(ROOT, "tools", "run-tests"), "p"], cwd=root, capture_output=True, text=True)
            runs = pathlib.Path(root, "runs")
            return (run.returncode, pathlib.Path(root, "build", "test-p.summary").read_text(encoding="utf-8"),
                    len(runs.read_text(encoding="utf-8").split()) if runs.exists() else 0)

    def fails_at_once(self, script, **options):
        code, closing, runs = self.run_on(script, **options)
        self.assertEqual((code, runs), (1, 1), closing)
        self.assertIn("Failed: A", closing)
        self.assertTrue(closing.endswith("0 passed, 1 failed, 0 skipped\n"), closing)

    def test_passes(self):
        self.assertEqual(self.run_on("true"), (0, "1 passed, 0 failed, 0 skipped\n", 1))

    def test_listed_and_passes_by_itself(self):
        code, closing, runs = self.run_on(FIRST_TIME_ONLY)
        self.assertEqual((code, runs), (0, 2))
        self.assertIn("Unsteady: A ", closing)
        self.assertTrue(closing.endswith("1 passed, 0 failed, 0 skipped\n"), closing)

    def test_listed_and_fails_twice(self):
        code, closing, runs = self.run_on(COMPARED)
        self.assertEqual((code, runs), (1, 2))
        self.assertNotIn("Unsteady", closing)

    def test_not_listed(self):
        self.fails_at_once(FIRST_TIME_ONLY, listed=False)

    def test_crash(self):
        self.fails_at_once("[ $runs -gt 1 ] || kill -SEGV $$")

    def test_crash_below_a_wrapper(self):
        self.fails_at_once("sh -c 'kill -SEGV $$'")

    def test_crash_of_a_child(self):
        for words in ("Segmentation fault (core dumped)", "QWARN : the program crashed: repair a.stl", "double free or corruption"):
            self.fails_at_once(f"echo '{words}'; {COMPARED}")

    def test_crash_after_the_last_line(self):
        totals = "echo 'Totals: 3 passed, 1 failed, 0 skipped'"
        self.fails_at_once(f"{totals}; kill -SEGV $$")
        for signal in ("SEGV", "BUS", "FPE", "ABRT"):
            self.fails_at_once(f"exec bash -c \"{totals}; bash -c 'kill -{signal} \\$\\$'; exit 1\"")

    def test_sanitizer(self):
        for report in ("ERROR: AddressSanitizer: heap-use-after-free", "WARNING: ThreadSanitizer: data race",
                       "a.cpp:3:1: runtime error: signed integer overflow"):
            self.fails_at_once(f"echo '{report}'; {COMPARED}")

    def test_hang(self):
        self.fails_at_once(f"sleep 5; {COMPARED}")

    def test_hang_after_the_last_line(self):
        self.fails_at_once("echo 'Totals: 3 passed, 1 failed, 0 skipped'; sleep 5")

    def test_hung_function(self):
        self.fails_at_once(f"echo 'QFATAL : Test function timed out'; {COMPARED}")

    def test_skipped(self):
        code, closing, _ = self.run_on("echo HANDWHEEL_DATA is not set")
        self.assertEqual((code, closing), (0, "Skipped: A\n0 passed, 0 failed, 1 skipped\n"))

    def test_skipped_and_then_serious(self):
        for report in ("WARNING: ThreadSanitizer: data race", "ERROR: LeakSanitizer: detected memory leaks", "Segmentation fault"):
            self.fails_at_once(f"echo HANDWHEEL_DATA is not set; echo '{report}'; exit 1")

    def test_missing_program(self):
        code, closing, _ = self.run_on("true", test="/nowhere/a")
        self.assertEqual(code, 1)
        self.assertTrue(closing.endswith("0 passed, 1 failed, 0 skipped\n"), closing)


if __name__ == "__main__":
    unittest.main()
