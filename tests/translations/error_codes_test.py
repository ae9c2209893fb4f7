#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The codes of errors (core/base/Error.h): each has an identifier of its own, is declared and described once, and its
texts are marked for translation. A sentence has neither capital nor full stop, an advice has both."""

import glob
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
LAYERS = ("core", "widgets", "app", "plugins")
DESCRIBED = re.compile(r"\bErrorDescription ((?:\w+::)*\w+)\s*\{\s*(\.id = .*?)\};", re.S)
DECLARED = re.compile(r"^(?:extern|  static) const ErrorDescription (\w+);", re.M)
SPACE = re.compile(r"^namespace handwheel::(\w+) \{|^class (ErrorCode) \{", re.M)
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')
MARKED = re.compile(r'translatable\(\s*"ErrorText",\s*"((?:[^"\\]|\\.)*)"\)')
JOINT = re.compile(r'(?<=[^\\{,(])"\s+"')  # between the parts of one text


def texts(description, member):
    """The texts of a member, and whether all of them are marked."""
    found = re.search(rf"\.{member} = \{{(.*?)\}}", description, re.S)
    inside = JOINT.sub("", found[1]) if found else ""
    return MARKED.findall(inside), not STRING.search(MARKED.sub("", inside))


def faults(name, description):
    sentences, marked = texts(description, "sentences")
    advice, also_marked = texts(description, "advice")
    if not (marked and also_marked):
        yield "a text is not marked with translatable(\"ErrorText\", ...)"
    if not sentences:
        yield "it has no sentence"
    yield from (f"“{s}” has a capital or a full stop" for s in sentences if s[0].isupper() or s.endswith("."))
    yield from (f"“{s}” is no sentence" for s in advice if not s.endswith("."))


def main():
    bad = '.id = "A", .sentences = {translatable("ErrorText", "It is odd."), "b"}, .advice = {translatable("ErrorText", "no")}'
    assert len(list(faults("A", bad))) == 3
    wrong, described, declared, owner = [], set(), set(), {}
    for layer in LAYERS:
        for path in sorted(glob.glob(f"{ROOT}/{layer}/**/*", recursive=True)):
            if not path.endswith((".h", ".cpp")):
                continue
            with open(path, encoding="utf-8") as file:
                text = file.read()
            where = os.path.relpath(path, ROOT)
            for match in DECLARED.finditer(text):
                space = [a or b for a, b in SPACE.findall(text[: match.start()])][-1]
                declared.add(f"{space}::{match[1]}")
            for name, description in DESCRIBED.findall(text):
                described.add(name)
                identifier = STRING.search(description)[1]
                if identifier in owner:
                    wrong.append(f"{where}: {name}: {owner[identifier]} is called {identifier}, too")
                owner[identifier] = name
                wrong += [f"{where}: {name}: {fault}" for fault in faults(name, description)]
    wrong += [f"{name} is declared and not described" for name in sorted(declared - described)]
    print("\n".join(wrong) if wrong else f"{len(described)} codes of errors are sound")
    assert len(described) > 30, "the sources are not understood"
    return 1 if wrong else 0


sys.exit(main())
