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
  std::size_t line = 0;  // number of the line, from 1
  bool isComment = false;
  std::size_t scope = 0;  // number of the routine that it is in, or of another scope, by the reader's count
};

// Splits lines at semicolons outside quotes. Empty parts are omitted. comment: the sign of comments, which become
// statements that begin with it; empty: none are in the lines.
std::vector<ProgramStatement> statementsOf(const std::vector<std::string_view>& lines, std::string_view comment = {});

// The routines of a program that call each other without arguments.
class ProgramRoutines {
 public:
  void begin(std::string name, std::size_t line);  // begins a routine, to which the statements until end() belong
  void end();                                      // ends the routine that was begun last; routines may be nested
  void add(const ProgramStatement& statement);

  // Returns the statements in the order of execution, with calls replaced by the called statements. The program begins
  // with the statements outside routines. If these are none but comments, it goes on with the routine `first`, or else
  // with the only routine that no routine calls. called: returns the name of the routine that a statement calls; empty:
  // none. Errors: ElementMalformed if the first routine is ambiguous, a called routine has the name of another one, a
  // routine calls itself, or there are too many statements.
  Result<std::vector<ProgramStatement>> unrolled(
      const std::string& first, const std::function<std::string(std::string_view statement)>& called) const;

 private:
  struct Routine {
    std::size_t line = 0;
    std::vector<ProgramStatement> statements;
    bool isTwice = false;  // another one has the same name
  };
  std::map<std::string, Routine> m_routines;
  std::vector<ProgramStatement> m_outside;
  bool m_hasOutside = false;     // true if these are not comments only
  std::vector<Routine*> m_open;  // the routines that were begun and not ended; in m_routines
};

}  // namespace handwheel
