# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every room of core is built, tested, and run by the presets for threads and coverage."""

import json
import os
import re
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
# A room that a preset leaves out, with the reason.
LEFT_OUT = {"tsan": {"document": "starts no thread; its tests are mostly Qt, which is not instrumented"}, "coverage": {}}


def text_of(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as stream:
        return stream.read()


def folders_of_core():
    core = os.path.join(ROOT, "core")
    return {name for name in os.listdir(core) if os.path.isdir(os.path.join(core, name))}


def named(presets, name):
    return next(preset for preset in presets if preset["name"] == name)


def rooms_built(presets, name):
    """The rooms whose tests the build preset makes."""
    targets = named(presets["buildPresets"], name)["targets"]
    return {m.group(1) for m in (re.fullmatch(r"tests/core/([a-z]+)/all", t) for t in targets) if m}


def rooms_run(presets, name, rooms):
    """The rooms whose tests the test preset runs; a test has the labels core and its room (tests/CMakeLists.txt)."""
    wanted = re.compile(named(presets["testPresets"], name)["filter"]["include"]["label"])
    return {room for room in rooms if wanted.search("core") or wanted.search(room)}


def missing(presets, rooms):
    """(preset, room, what does not name it) of each room that is in neither list nor LEFT_OUT, or in both."""
    for preset, left_out in LEFT_OUT.items():
        for what, found in (("build", rooms_built(presets, preset)), ("test", rooms_run(presets, preset, rooms))):
            for room in sorted((rooms - set(left_out)) ^ found):
                yield preset, room, what


class PresetsTest(unittest.TestCase):
    def setUp(self):
        self.rooms = folders_of_core()
        self.presets = json.loads(text_of("CMakePresets.json"))

    def test_rooms_are_built(self):
        self.assertEqual(set(re.findall(r"add_subdirectory\((\w+)\)", text_of("core", "CMakeLists.txt"))), self.rooms)

    def test_rooms_are_tested(self):
        listed = re.search(r"foreach\(room ([a-z ]+)\)", text_of("tests", "CMakeLists.txt")).group(1)
        self.assertEqual(set(listed.split()), self.rooms)

    def test_presets_name_every_room(self):
        self.assertEqual(list(missing(self.presets, self.rooms)), [])

    def test_finds_a_missing_room(self):
        more = self.rooms | {"lathe"}
        self.assertEqual(
            list(missing(self.presets, more)),
            [("tsan", "lathe", "build"), ("tsan", "lathe", "test"), ("coverage", "lathe", "build")],
        )
        targets = named(self.presets["buildPresets"], "tsan")["targets"]
        targets.remove("tests/core/mesh/all")
        self.assertEqual(list(missing(self.presets, self.rooms)), [("tsan", "mesh", "build")])


if __name__ == "__main__":
    unittest.main()
