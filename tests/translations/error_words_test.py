#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every phrase that the sources put into an error stands in widgets/text/ErrorWords.cpp, so that it is translated.

Gathered are the literals in the arguments that a sentence shows as words: where an Error is made, and in the calls of
functions of the same file that pass a parameter on into one. A name or a number within a phrase counts as %1."""

import glob
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# Where the command line alone would show it, English is enough.
SOURCES = ("core/**/*", "widgets/**/*", "plugins/**/*", "app/devices/*", "app/fidelity/*", "app/window/**/*")
# Which argument of a code is a phrase. Names of elements, properties and libraries stay as they are.
PHRASE = {
    "ArchiveError::Malformed": 0, "DeviceError::NotResponding": 0, "DeviceError::PluginBroken": 0,
    "DeviceError::Unreachable": 0, "CellError::PlansFull": 0, "DocumentError::CheckFailed": 0, "ErrorCode::CountMismatch": 0,
    "ErrorCode::DataTruncated": 0, "ErrorCode::ElementMalformed": 1, "ErrorCode::FileTooLarge": 0,
    "ErrorCode::FileUnreadable": 0, "ErrorCode::LibraryFailed": 1, "ErrorCode::ReferenceMissing": 0,
    "ErrorCode::Unsupported": 0, "ExerciseError::FieldRefused": 1, "ErrorCode::WriteFailed": 0, "MeshFileError::TokenUnexpected": 0,
}
MADE = re.compile(r"\b((?:ErrorCode|\w+Error)::\w+),\s*\{")
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')
HEAD = re.compile(r"(\w+)(?:\s*=\s*\[[^\]]*\])?\s*\(((?:[^(){};]|\([^()]*\))*)\)[^;{}()]*\{")


def arguments(text, start):
    """The expressions between the bracket that opens before start and the one that closes it."""
    parts, depth, at = [""], 0, start
    while at < len(text):
        string = STRING.match(text, at)
        if string:
            parts[-1] += string.group(0)
            at = string.end()
            continue
        c = text[at]
        if c in "([{":
            depth += 1
        elif c in ")]}":
            if depth == 0:
                break
            depth -= 1
        if c == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
        at += 1
    return [part.strip() for part in parts]


def phrases(expression):
    """What an expression says: for each branch its literals, with %1 for what stands between them."""
    for branch in re.split(r"[?:](?=(?:[^\"]*\"[^\"]*\")*[^\"]*$)", expression.replace("::", "  ")):
        if not STRING.search(branch):
            continue
        said, end = "", 0
        for literal in STRING.finditer(branch):
            if "+" in branch[end : literal.start()]:
                said += "%1" if branch[end : literal.start()].strip(" +\n\t()") not in ("", "std  string") else ""
            said += literal.group(1)
            end = literal.end()
        yield said + ("%1" if "+" in branch[end:] else "")


def enclosing(text, at):
    """Name and parameters of the function around a place."""
    last = None
    for head in HEAD.finditer(text, 0, at):
        if head.group(1) not in ("if", "for", "while", "switch", "catch"):
            last = head
    if not last:
        return "", []
    names = [re.sub(r"=.*", "", p).strip().split(" ")[-1].lstrip("&*") for p in last.group(2).split(",")]
    return last.group(1), names


def of_file(text):
    text = re.sub(r"//[^\n]*", "", text)
    for made in MADE.finditer(text):
        position = PHRASE.get(made.group(1))
        given = arguments(text, made.end())
        if position is None or position >= len(given):
            continue
        yield from phrases(given[position])
        function, parameters = enclosing(text, made.start())
        passed = re.findall(r"\b[a-z]\w*\b", STRING.sub("", given[position]))
        for i, name in enumerate(parameters):
            if name not in passed or STRING.search(given[position]):
                continue
            for call in re.finditer(rf"\b{function}\(", text):
                values = arguments(text, call.end())
                if i < len(values):
                    yield from phrases(values[i])


def known():
    with open(os.path.join(ROOT, "widgets/text/ErrorWords.cpp"), encoding="utf-8") as file:
        return re.findall(r'QT_TRANSLATE_NOOP\("ErrorWord", "((?:[^"\\]|\\.)*)"\)', file.read())


def is_known(phrase, words):
    """Also where a part of it has words of its own, which then stand in ErrorWords as a whole."""
    fits = lambda pattern, text: re.fullmatch(re.escape(pattern).replace("%1", ".+"), text)
    return any(fits(word, phrase) or fits(phrase, word) for word in words)


def main():
    assert list(phrases('"its type \'" + name + "\' is not known"')) == ["its type '%1' is not known"]
    assert list(of_file('Error f(int a, const char* what) {\n return {ErrorCode::ElementMalformed, {a, what}};\n}\n'
                        'x = f(1, "it is odd");')) == ["it is odd"]
    words, gathered = known(), {}
    for pattern in SOURCES:
        for path in glob.glob(os.path.join(ROOT, pattern), recursive=True):
            if not path.endswith((".cpp", ".h")):
                continue
            with open(path, encoding="utf-8") as file:
                for phrase in of_file(file.read()):
                    gathered.setdefault(phrase, os.path.relpath(path, ROOT))
    missing = {p: f for p, f in gathered.items() if p and p != "%1" and not is_known(p, words)}
    for phrase, path in sorted(missing.items(), key=lambda each: each[1]):
        print(f"{path}: “{phrase}” is not in ErrorWords")
    print(f"{len(gathered)} phrases gathered")
    assert len(gathered) > 80, "the sources are not understood"
    return 1 if missing else 0


sys.exit(main())
