#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What docs/robots.md tells people to choose, to type and to press is what the program has: each phrase in italics is
one of its texts, each option one of the command line, each key that of the tool or action beside it."""

import glob
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PAGE = "docs/robots.md"
# A literal, or what may hold a quotation mark that begins none.
TOKEN = re.compile(r'R"\((?:.|\n)*?\)"|//[^\n]*|\'(?:[^\'\\\n]|\\.)\'|"((?:[^"\\\n]|\\.)*)"')


def sources(folders):
    text = ""
    for folder in folders:
        for path in sorted(glob.glob(os.path.join(ROOT, folder, "**", "*"), recursive=True)):
            if path.endswith((".cpp", ".h")):
                with open(path, encoding="utf-8") as file:
                    text += re.sub(r'"\s*\n\s*"', "", file.read())  # literals that go on in the next line
    return text


def literals(source):
    """Each with the place where it ends."""
    return [(m.group(1), m.end()) for m in TOKEN.finditer(source) if m.group(1) is not None]


def plain(text):
    return re.sub(r"\s+", " ", text.replace("&", "").replace("…", "").replace('\\"', '"')).strip().casefold()


def names_missing(page, texts):
    """Phrases in italics, and the parts of a way through menus, that no text of the program is or begins with."""
    missing = []
    for phrase in re.findall(r"(?<![*\w])\*([^*\n]+)\*(?![*\w])", page):
        for part in phrase.split("→"):
            name = plain(part)
            if not any(each == name or each.startswith(name) for each in texts):
                missing.append(part.strip())
    return missing


def options_missing(page, words):
    return sorted({option for option in re.findall(r"--([a-z][a-z-]*)", page) if option not in words})


def keys_missing(page, source):
    """Of "*Name* (Shift+W)": the key must stand near the name in the source, where the action is made."""
    missing = []
    for name, key in re.findall(r"\*([^*\n]+)\* \(((?:Shift\+|Ctrl\+)?(?:[A-Z]|F\d+))\)", page):
        wanted = "Qt::Key_" + key.split("+")[-1]
        if key.startswith("Shift+"):
            wanted = "Qt::SHIFT | " + wanted
        near = [end for text, end in literals(source) if plain(text) == plain(name)]
        is_editing = key == "F2"  # by the list itself: QAbstractItemView::EditKeyPressed
        if not is_editing and not any(wanted in source[at:at + 900] for at in near):
            missing.append(f"{name} ({key})")
    return missing


def self_test():
    texts = {plain("&Plan a path…"), plain("Cell")}
    assert names_missing("*Cell → Plan a path…*", texts) == []
    assert names_missing("*Plan no path*", texts) == ["Plan no path"]
    assert options_missing("`--clearance 10` and `--nothing`", {"clearance"}) == ["nothing"]
    made = 'tr("&Lead"), QKeySequence(Qt::SHIFT | Qt::Key_J)'
    assert keys_missing("*Lead* (Shift+J)", made) == []
    assert keys_missing("*Lead* (Shift+K)", made) == ["Lead (Shift+K)"]
    assert [text for text, _ in literals("a = '\"'; f(\"b\");  // \"c\"")] == ["b"]
    assert keys_missing("*Lead* (J)", 'tr("&Lead"), QKeySequence(Qt::Key_J)') == []


def main():
    self_test()
    with open(os.path.join(ROOT, PAGE), encoding="utf-8") as file:
        page = file.read()
    window, commands = sources(["app", "widgets", "core", "plugins"]), sources(["app/cli", "app/fidelity", "core"])
    texts = {plain(text) for text, _ in literals(window)}
    words = {text.split(".")[-1] for text, _ in literals(commands)}
    problems = [f"no text of the program: {each}" for each in names_missing(page, texts)]
    problems += [f"no option: --{each}" for each in options_missing(page, words)]
    problems += [f"another key: {each}" for each in keys_missing(page, window)]
    for problem in problems:
        print(f"{PAGE}: {problem}")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
