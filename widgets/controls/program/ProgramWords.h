// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringView>
#include <vector>

namespace handwheel {

// A word of a machine program, classified for its colour. The kind depends only on the letters; the interpreter of a
// machine decides if the word is valid.
struct EditorWord {
  enum class Kind {
    Comment,      // ( … ) to its end or the end of the line, ; …
    Preparatory,  // G and its number
    Machine,      // M, T, S, F, D, H and their numbers
    Axis,         // X Y Z A B C U V W I J K R E L P Q
    Number,       // the number of an axis word, or a number without a letter
    LineNumber,   // N and its number
    Subprogram,   // O and its number or name
    Variable,     // #1, #<name>
    Keyword,      // IF, WHILE, SIN, EQ
    Unknown,      // a character that occurs in no program
  };
  int start = 0;
  int length = 0;
  Kind kind = Kind::Unknown;
  bool operator==(const EditorWord&) const = default;
};

// Returns the words of a line, in order, without blanks and operators. May be called on any thread. Linear in the
// length of the line.
std::vector<EditorWord> programWords(QStringView line);

}  // namespace handwheel
