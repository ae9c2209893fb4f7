// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramExpression.h"

#include <optional>
#include <vector>

namespace handwheel {

// A letter with its value.
struct ProgramWord {
  char letter = 0;  // capital
  double number = 0.0;
  bool hasPoint = false;  // the number was written with a decimal point, or computed
  SourceLocation location;

  std::string text() const;  // for example "G71.1"
};

// The words of one line, read and evaluated.
struct ProgramBlock {
  static constexpr std::size_t kMostWords = 100;

  std::vector<ProgramWord> words;  // without N; vacant ones are left out
  SourceLocation location;         // location of its first word

  // Returns the word with this letter, or null. Of several G or M, the first.
  const ProgramWord* find(char letter) const;
  bool has(char letter) const { return find(letter) != nullptr; }
  double number(char letter, double otherwise) const;
};

// Reads a line from the scanner, then sets the variables that it assigns: after the whole line is read, as both
// dialects do. Refuses repeated letters, except G and M.
ProgramBlock readBlock(ProgramScanner& scanner, ProgramVariables& variables, ProgramDialect dialect);

}  // namespace handwheel
