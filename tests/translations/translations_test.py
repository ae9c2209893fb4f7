# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/translations finds each way in which a translation can break what is shown, and lets good ones pass."""

import os
import subprocess
import tempfile
import unittest
from xml.sax.saxutils import escape

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
PAGE = """<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="{language}" sourcelanguage="en">
<context><name>Menu</name><message{plural}><source>{source}</source>{translation}</message></context>
</TS>
"""


class TranslationsTest(unittest.TestCase):
    def run_on(self, source, forms, language, plural, arguments=()):
        inner = "".join(f"<numerusform>{escape(f)}</numerusform>" for f in forms) if plural else escape(forms[0])
        state = "" if any(forms) else ' type="unfinished"'
        page = PAGE.format(
            language=language,
            plural=' numerus="yes"' if plural else "",
            source=escape(source),
            translation=f"<translation{state}>{inner}</translation>",
        )
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, f"handwheel_{language}.ts")
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(page)
            command = [os.path.join(ROOT, "tools", "translations"), "check", *arguments, path]
            return subprocess.run(command, capture_output=True, text=True)

    def assert_good(self, source, *forms, language="de", plural=False):
        run = self.run_on(source, forms, language, plural)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def assert_bad(self, source, *forms, language="de", plural=False):
        run = self.run_on(source, forms, language, plural)
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        self.assertIn("Menu", run.stdout)

    def test_markers(self):
        self.assert_good("%1 of %2", "%2: davon %1")
        self.assert_bad("%1 of %2", "%1 von %1")
        self.assert_bad("%L1 faces", "%1 Flächen")
        self.assert_bad("Saved", "Gesichert %1")
        self.assert_bad("One<br>two", "Eins, zwei")
        self.assert_bad("Meshes (*.stl *.ply)", "Netze (*.stl)")

    def test_accelerators(self):
        self.assert_good("&Open", "Ö&ffnen")
        self.assert_good("Search && rescue", "Suchen && retten")
        self.assert_good("&Open…", "打开(&O)…", language="zh_CN")
        self.assert_bad("&Open", "Öffnen")
        self.assert_bad("Open", "Ö&ffnen")

    def test_closing_punctuation(self):
        self.assert_good("The file is empty.", "文件为空。", language="zh_CN")
        self.assert_good("Save in:", "保存到：", language="zh_CN")
        self.assert_bad("Open…", "Öffnen")
        self.assert_bad("The file is empty.", "Die Datei ist leer")
        self.assert_bad("Holes", "Löcher:")
        self.assert_bad("Name ", "Name")

    def test_plural_forms(self):
        self.assert_good("%n hole(s)", "%n Loch", "%n Löcher", plural=True)
        self.assert_good("%n hole(s)", "%n 个孔洞", language="zh_CN", plural=True)
        self.assert_bad("%n hole(s)", "%n Loch", plural=True)
        self.assert_bad("%n hole(s)", "%n Loch", "", plural=True)
        self.assert_bad("%n hole(s)", "Ein Loch", "%n Löcher", plural=True)

    def test_what_is_not_translated_matters_to_the_complete_check_only(self):
        self.assert_good("Holes", "")
        run = self.run_on("Holes", ("",), "de", False, ("--complete",))
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        self.assertIn("“Holes”: not translated", run.stdout)
        self.assertIn("“Holes”: no longer in the sources", run.stdout)


if __name__ == "__main__":
    unittest.main()
