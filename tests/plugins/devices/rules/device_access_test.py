#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/device-access on pretended trees of /sys and /dev, and the udev rules that it advises."""

import fnmatch
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[4]
TOOL = ROOT / "tools" / "device-access"
RULES = (ROOT / "plugins" / "devices" / "70-handwheel.rules").read_text()


class DeviceAccess(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.sys, self.dev = Path(self.folder.name, "sys"), Path(self.folder.name, "dev")
        self.sys.mkdir()
        self.dev.mkdir()

    def tearDown(self):
        self.folder.cleanup()

    def node(self, name, mode):
        path = self.dev / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
        path.chmod(mode)

    def write(self, path, text):
        file = self.sys / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text + "\n")

    def hid(self, node, identity, name, mode=0):
        self.write(f"class/hidraw/{node}/device/uevent", f"DRIVER=hid-generic\nHID_ID={identity}\nHID_NAME={name}")
        self.node(node, mode)

    def run_tool(self):
        # As root every node may be opened.
        command = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"] if os.geteuid() == 0 else []
        os.chmod(self.folder.name, 0o755)
        done = subprocess.run([*command, TOOL, self.sys, self.dev], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_nothing_is_plugged_in(self):
        self.assertEqual(self.run_tool(), "")

    def test_bluetooth_and_usb(self):
        self.hid("hidraw0", "0005:0000256F:0000C63A", "SpaceMouse Wireless BT")
        self.hid("hidraw1", "0003:0000046D:0000C626", "3Dconnexion SpaceNavigator")
        self.hid("hidraw2", "0003:0000046D:0000C52B", "Logitech Receiver")
        said = self.run_tool()
        self.assertIn("SpaceMouse Wireless BT (" + str(self.dev / "hidraw0"), said)
        self.assertIn("SpaceNavigator", said)
        self.assertNotIn("Logitech", said)
        self.assertIn("70-handwheel.rules\" /etc/udev/rules.d/", said)

    def test_what_may_be_opened_is_passed_over(self):
        self.hid("hidraw0", "0003:0000256F:0000C635", "SpaceMouse Compact", 0o666)
        self.assertEqual(self.run_tool(), "")

    def test_falcon_and_polhem(self):
        for name, vendor, product in (("1-2", "0403", "cb48"), ("1-3", "16c0", "0483"), ("1-4", "0403", "6001")):
            for file, text in (("idVendor", vendor), ("idProduct", product), ("busnum", "1"), ("devnum", name[2:])):
                self.write(f"bus/usb/devices/{name}/{file}", text)
        for number in (2, 3, 4):
            self.node(f"bus/usb/001/00{number}", 0)
        self.write("bus/usb/devices/1-3/1-3:1.0/uevent", "")
        (self.sys / "class/tty/ttyACM0").mkdir(parents=True)
        (self.sys / "class/tty/ttyACM0/device").symlink_to(self.sys / "bus/usb/devices/1-3/1-3:1.0")
        self.node("ttyACM0", 0)
        said = self.run_tool()
        self.assertIn("Novint Falcon (" + str(self.dev / "bus/usb/001/002"), said)
        self.assertIn("Polhem (" + str(self.dev / "ttyACM0"), said)
        self.assertEqual(said.count("You may not open"), 2)


class Rules(unittest.TestCase):
    # The kernel names HID devices bus:vendor:product.number in capitals; 0005 is Bluetooth, where nothing above has ids.
    def test_bluetooth(self):
        patterns = re.findall(r'^KERNEL=="hidraw\*", KERNELS=="([^"]*)", TAG\+="uaccess"', RULES, re.MULTILINE)
        for name, is_ours in (("0005:256F:C63A.0004", True), ("0005:256F:C638.000A", True), ("0005:046D:B342.0001", False)):
            self.assertEqual(any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns), is_ours, name)


if __name__ == "__main__":
    unittest.main()
