// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramExpression.h"

#include <optional>
#include <vector>

namespace handwheel {

// A word of a program: a letter with its value.
struct ProgramWord {
  char letter = 0;  // capital; 'c' and 'r' are ,C and ,R of a Fanuc
  double number = 0.0;
  bool hasPoint = false;  // true if the number was written with a decimal point, or computed
  SourceLocation location;

  std::string text() const;  // for example "G71.1"
};

// The words of one line, read and evaluated.
struct ProgramBlock {
  static constexpr std::size_t kMostWords = 100;

  std::vector<ProgramWord> words;  // without N and without words whose value is vacant
  SourceLocation location;         // location of the first word
  std::optional<double> sequence;  // number after N

  // Returns the first word with this letter, or null if there is none. Only G and M may occur several times.
  const ProgramWord* find(char letter) const;
  bool has(char letter) const { return find(letter) != nullptr; }
  double number(char letter, double otherwise) const;
};

// Takes the block skips that come next. Returns true if the setup skips what follows them in the line.
bool skipsRest(ProgramScanner& scanner, const ProgramSetup& setup);

// Reads a line from the scanner, up to a skip that is on, and sets the variables that the line assigns. They are set
// after the whole line is read, as both dialects require. Throws ProgramRefusal if a letter other than G and M is
// repeated.
ProgramBlock readBlock(ProgramScanner& scanner, ProgramVariables& variables, const ProgramSetup& setup);

}  // namespace handwheel
