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

// A statement of a program, without what separates it from the next.
struct ProgramStatement {
  std::string_view text;
  std::size_t line = 0;  // from 1
};

// The parts of these lines between semicolons that are not in quotes; empty ones are left out.
std::vector<ProgramStatement> statementsOf(const std::vector<std::string_view>& lines);

// The routines of a program that call each other without arguments.
class ProgramRoutines {
 public:
  void begin(std::string name, std::size_t line);  // of a routine, which has the statements until end()
  void end();                                      // of the one that was begun last; routines may stand within others
  void add(const ProgramStatement& statement);

  // The statements in the order in which they are carried out: those outside of routines, else those of `first`, else
  // those of the one routine that no other calls; calls are replaced by what is called. called: the routine that a
  // statement calls; empty: none. Errors: ElementMalformed where it is not given which routine is the first, one calls
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
