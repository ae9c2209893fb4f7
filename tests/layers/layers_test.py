# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/layers finds each kind of include that must not be, and lets the others pass."""

import os
import subprocess
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
ROOMS = {"core": ("base", "mesh", "document"), "widgets": ("viewport", "panels"), "app": ("cli", "window", "builtin")}
PLUGINS = {"devices": ("io", "falcon", "haply"), "formats": ("step",)}


class LayersTest(unittest.TestCase):
    def run_on(self, path, include, architecture=""):
        with tempfile.TemporaryDirectory() as root:
            for layer, rooms in ROOMS.items():
                for room in rooms:
                    os.makedirs(os.path.join(root, layer, room))
                with open(os.path.join(root, layer, "CMakeLists.txt"), "w", encoding="utf-8") as stream:
                    stream.writelines(f"add_subdirectory({room})\n" for room in rooms)
            for folder in ("core/document/cell", "core/document/workpiece", "core/document/formats", "app/window/cell", "app/window/workpiece",
                           "app/window/haptics"):
                os.makedirs(os.path.join(root, folder))
            for sort, plugins in PLUGINS.items():
                for plugin in plugins:
                    os.makedirs(os.path.join(root, "plugins", sort, plugin))
                with open(os.path.join(root, "plugins", sort, "CMakeLists.txt"), "w", encoding="utf-8") as stream:
                    stream.writelines(f"add_subdirectory({plugin})\n" for plugin in plugins)
            os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8") as stream:
                stream.write(f"\n#include {include}\n")
            with open(os.path.join(root, "ARCHITECTURE.md"), "w", encoding="utf-8") as stream:
                stream.write(architecture)
            run = subprocess.run([os.path.join(ROOT, "tools", "layers"), root], capture_output=True, text=True)
            return run.returncode, run.stdout

    def assert_refused(self, path, include):
        code, output = self.run_on(path, include)
        self.assertEqual(code, 1, f"{path} includes {include}: {output}")
        self.assertTrue(output.startswith(f"{path}:2: "), output)

    def assert_allowed(self, path, include):
        code, output = self.run_on(path, include)
        self.assertEqual(code, 0, output)

    def test_map(self):
        def output_of(architecture):
            return self.run_on("core/mesh/A.h", '"base/B.h"', architecture)

        self.assertEqual(output_of("    core/     everything\n      mesh/   meshes\n- **A** (`mesh/A.h`): `core/mesh/A.h`, `a.h`\n")[0], 0)
        self.assertEqual(output_of("# Map\n- **B** (`mesh/B.h`)\n"), (1, "ARCHITECTURE.md:2: mesh/B.h: there is none\n"))
        self.assertEqual(output_of("    core/     all\n      mash/   meshes\n"), (1, "ARCHITECTURE.md:2: core/mash/: there is none\n"))

    def test_arrows(self):
        self.assert_allowed("core/mesh/A.h", '"base/B.h"')
        self.assert_allowed("core/mesh/A.h", '"mesh/B.h"')
        self.assert_allowed("app/window/A.cpp", '"A.moc"')
        self.assert_refused("core/base/A.h", '"mesh/B.h"')
        self.assert_allowed("core/mesh/holes/A.h", '"mesh/structure/B.h"')
        self.assert_refused("core/mesh/structure/A.h", '"mesh/holes/B.h"')
        self.assert_refused("core/document/A.cpp", '"panels/B.h"')
        self.assert_refused("widgets/viewport/A.cpp", '"panels/B.h"')
        self.assert_refused("widgets/panels/A.cpp", '"window/B.h"')

    def test_kinds(self):
        self.assert_allowed("app/window/cell/A.cpp", '"document/cell/B.h"')
        self.assert_allowed("app/window/cell/A.cpp", '"window/cell/B.h"')
        self.assert_allowed("core/document/cell/A.cpp", '"document/cell/B.h"')
        self.assert_allowed("app/builtin/A.cpp", '"window/cell/B.h"')
        self.assert_allowed("app/window/A.cpp", '"window/haptics/B.h"')
        self.assert_allowed("app/window/A.cpp", '"document/formats/B.h"')
        self.assert_refused("app/window/A.cpp", '"window/cell/B.h"')
        self.assert_refused("app/window/haptics/A.h", '"document/cell/B.h"')
        self.assert_refused("core/document/A.cpp", '"document/cell/B.h"')
        self.assert_refused("widgets/panels/A.h", '"document/cell/B.h"')
        self.assert_refused("app/cli/A.cpp", '"document/cell/B.h"')
        self.assert_refused("app/window/cell/A.cpp", '"document/workpiece/B.h"')
        self.assert_allowed("app/cli/cell/A.cpp", '"document/cell/B.h"')
        # Those that know one all the same are listed, as long as they do.
        self.assert_allowed("app/cli/Input.cpp", '"document/cell/B.h"')
        code, output = self.run_on("app/cli/Input.cpp", '"base/B.h"')
        self.assertEqual(code, 1)
        self.assertIn("strike it", output)

    def test_paths(self):
        self.assert_refused("core/mesh/A.cpp", '"A.h"')
        self.assert_refused("core/mesh/A.cpp", '"../base/B.h"')
        self.assert_refused("core/mesh/A.cpp", '"cellar/B.h"')

    def test_qt(self):
        self.assert_allowed("core/document/A.h", "<QUndoStack>")
        self.assert_allowed("core/document/A.h", "<QtCore/qglobal.h>")
        self.assert_allowed("widgets/panels/A.h", "<QWidget>")
        self.assert_refused("core/mesh/A.h", "<QString>")
        self.assert_refused("core/mesh/A.h", "<qglobal.h>")
        self.assert_refused("core/document/A.h", "<QWidget>")
        self.assert_refused("core/document/A.h", "<QtWidgets/QWidget>")
        self.assert_refused("core/document/A.h", "<QOpenGLWidget>")

    def test_plugins(self):
        self.assert_allowed("plugins/devices/falcon/A.h", '"base/B.h"')
        self.assert_allowed("plugins/devices/falcon/A.h", '"io/B.h"')
        self.assert_allowed("plugins/devices/falcon/A.h", '"falcon/B.h"')
        self.assert_allowed("plugins/devices/falcon/A.cpp", '"A.moc"')
        self.assert_allowed("plugins/devices/falcon/A.cpp", "<QObject>")
        self.assert_allowed("plugins/devices/falcon/A.cpp", "<libusb.h>")
        self.assert_refused("plugins/devices/falcon/A.cpp", '"haply/B.h"')
        self.assert_refused("plugins/devices/io/A.cpp", '"haply/B.h"')
        self.assert_refused("plugins/devices/falcon/A.cpp", '"viewport/B.h"')
        self.assert_refused("plugins/devices/falcon/A.cpp", '"window/B.h"')
        self.assert_refused("plugins/devices/falcon/A.cpp", '"B.h"')
        self.assert_refused("plugins/devices/falcon/A.h", "<QObject>")
        self.assert_refused("plugins/devices/falcon/A.cpp", "<QWidget>")
        self.assert_refused("core/mesh/A.cpp", '"falcon/B.h"')
        self.assert_allowed("plugins/formats/step/A.cpp", '"base/B.h"')
        self.assert_allowed("plugins/formats/step/A.cpp", '"step/B.h"')
        self.assert_refused("plugins/formats/step/A.cpp", '"io/B.h"')
        self.assert_refused("plugins/formats/step/A.cpp", '"viewport/B.h"')
        self.assert_refused("core/document/A.cpp", '"step/B.h"')
        self.assert_refused("app/window/A.cpp", '"io/B.h"')

    def test_libraries(self):
        self.assert_allowed("core/mesh/A.cpp", "<CGAL/Surface_mesh.h>")
        self.assert_allowed("widgets/viewport/A.cpp", "<vtkActor.h>")
        self.assert_allowed("core/mesh/A.cpp", "<vtkPolyData.h>")
        self.assert_refused("core/mesh/A.h", "<CGAL/Surface_mesh.h>")
        self.assert_refused("core/mesh/A.cpp", "<vtkRenderer.h>")
        self.assert_refused("widgets/panels/A.cpp", "<vtkActor.h>")


if __name__ == "__main__":
    unittest.main()
