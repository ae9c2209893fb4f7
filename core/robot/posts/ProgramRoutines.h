// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// A statement of a program, without its separator.
struct ProgramStatement {
  std::string_view text;
  std::size_t line = 0;  // from 1
};

// Splits these lines at semicolons that are not in quotes; empty parts are left out.
std::vector<ProgramStatement> statementsOf(const std::vector<std::string_view>& lines);

// The routines of a program that call each other without arguments.
class ProgramRoutines {
 public:
  void begin(std::string name, std::size_t line);  // begins a routine, which has the statements until end()
  void end();                                      // ends the routine that was begun last; routines may be nested
  void add(const ProgramStatement& statement);

  // Returns the statements in the order of execution: those outside routines, otherwise those of `first`, otherwise
  // those of the only routine that no other calls; calls are replaced by the called statements. called: returns the
  // routine that a statement calls; empty: none. Errors: ElementMalformed if the first routine is ambiguous, one calls
  // itself, or there are too many statements.
  Result<std::vector<ProgramStatement>> unrolled(
      const std::string& first, const std::function<std::string(std::string_view statement)>& called) const;

 private:
  struct Routine {
    std::size_t line = 0;
    std::vector<ProgramStatement> statements;
  };
  std::map<std::string, Routine> m_routines;
  std::vector<ProgramStatement> m_outside;
  std::vector<Routine*> m_open;  // in m_routines
};

}  // namespace handwheel
