// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <string>

// The error codes of lathe programs. Their position is the line.
namespace handwheel::ProgramError {

extern const ErrorDescription Refused;        // {column, word, what is wrong with it, what to do}
extern const ErrorDescription Endless;        // {blocks}; more were executed than any program has
extern const ErrorDescription TooManyMoves;   // {moves}
extern const ErrorDescription CyclesCollide;  // {line}; made for a target
extern const ErrorDescription CyclesGouge;    // {mm, z} into the target

}  // namespace handwheel::ProgramError

namespace handwheel {

// A location in the text of a program, both from 1. Columns count bytes.
struct SourceLocation {
  std::uint32_t line = 0, column = 0;
};

// The exception that carries an error out of the interpreter; thrown and caught inside this folder only.
struct ProgramRefusal {
  Error error;
};

// Throws the refusal of a word. reason follows "word: "; remedy is a whole sentence.
[[noreturn]] void refuse(const SourceLocation& location, const std::string& word, const std::string& reason,
                         const std::string& remedy);

}  // namespace handwheel
