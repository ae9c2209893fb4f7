// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <string>

// The error codes of lathe programs. The position of an error is the line of the program.
namespace handwheel::ProgramError {

extern const ErrorDescription Refused;        // {column, word, what is wrong with it, what to do}
extern const ErrorDescription Unmakeable;     // the same of a program that is to be made; it has no columns
extern const ErrorDescription Alarm;          // {number, message}; the program stopped the machine with an alarm
extern const ErrorDescription Endless;        // {blocks}; more blocks were executed than any sensible program has
extern const ErrorDescription TooManyMoves;   // {moves}
extern const ErrorDescription CyclesCollide;  // {line}; cycles made for a target collide
extern const ErrorDescription CyclesGouge;    // {mm, z}; cycles cut this deep into the target, at this z

}  // namespace handwheel::ProgramError

namespace handwheel {

// A location in the text of a program. Lines and columns count from 1; columns count bytes.
struct SourceLocation {
  std::uint32_t line = 0, column = 0;
};

// The exception that carries an error out of the interpreter. It is thrown and caught inside this folder only.
struct ProgramRefusal {
  Error error;
};

// Throws the alarm that a program sets off. number: the number that a control shows. message: may be empty.
[[noreturn]] void alarm(const SourceLocation& location, const std::string& number, const std::string& message);

// Throws the refusal of a word, or, without a location, of a program that is to be made. reason: a clause that follows
// "word: ". remedy: a whole sentence.
[[noreturn]] void refuse(const SourceLocation& location, const std::string& word, const std::string& reason,
                         const std::string& remedy);

}  // namespace handwheel
