# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shipped scan is what tools/make-sample.py makes, and has the defects that its README promises."""

import collections
import os
import struct
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", ".."))
SAMPLE = os.path.join(ROOT, "resources", "samples", "scan-with-holes.stl")


def triangles_of(path):
    with open(path, "rb") as stream:
        data = stream.read()
    count = struct.unpack_from("<I", data, 80)[0]
    assert len(data) == 84 + 50 * count
    return [tuple(data[84 + 50 * i + 12 * c:96 + 50 * i + 12 * c] for c in (1, 2, 3)) for i in range(count)]


def connected(links):
    """Sizes of the parts of a graph {node: neighbours}."""
    left, sizes = set(links), []
    while left:
        front, size = [left.pop()], 0
        while front:
            size += 1
            for node in links[front.pop()]:
                if node in left:
                    left.remove(node)
                    front.append(node)
        sizes.append(size)
    return sorted(sizes, reverse=True)


class SampleTest(unittest.TestCase):
    def test_is_reproducible(self):
        with tempfile.TemporaryDirectory() as folder:
            again = os.path.join(folder, "again.stl")
            subprocess.run([sys.executable, os.path.join(ROOT, "tools", "make-sample.py"), again], check=True,
                           stdout=subprocess.DEVNULL)
            with open(again, "rb") as made, open(SAMPLE, "rb") as shipped:
                self.assertTrue(made.read() == shipped.read())

    def test_defects(self):
        triangles = triangles_of(SAMPLE)
        proper = [t for t in triangles if len(set(t)) == 3]
        self.assertEqual(len(triangles) - len(proper), 1)
        distinct = {frozenset(t): t for t in proper}
        self.assertEqual(len(proper) - len(distinct), 1)

        directed = collections.Counter((a, b) for t in distinct.values() for a, b in zip(t, t[1:] + t[:1]))
        self.assertEqual(sum(n == 2 for n in directed.values()), 9)  # three turned faces, three edges each
        undirected = collections.Counter(frozenset(e) for e, n in directed.items() for _ in range(n))
        self.assertLessEqual(max(undirected.values()), 2)

        rim, surface = collections.defaultdict(set), collections.defaultdict(set)
        for edge, faces in undirected.items():
            a, b = edge
            surface[a].add(b)
            surface[b].add(a)
            if faces == 1:
                rim[a].add(b)
                rim[b].add(a)
        self.assertTrue(all(len(around) == 2 for around in rim.values()))
        self.assertEqual(connected(rim), [173, 44, 44, 42, 38, 17, 3])
        self.assertEqual(connected(surface)[1:], [6])  # the part, and a flake of six vertices


if __name__ == "__main__":
    unittest.main()
