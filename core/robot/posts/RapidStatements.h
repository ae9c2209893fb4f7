// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/ProgramRoutines.h"

namespace handwheel {

// Returns a name in lower case, as RAPID is not case-sensitive.
std::string folded(std::string_view name);

// A RAPID module, split into declarations of data and the statements of its procedures. A statement may span several
// lines, and a line may contain several statements. Functions, traps and error handlers are omitted.
class RapidStatements {
 public:
  explicit RapidStatements(const std::vector<std::string_view>& lines);  // lines: without comments
  RapidStatements(const RapidStatements&) = delete;
  RapidStatements& operator=(const RapidStatements&) = delete;

  const std::vector<ProgramStatement>& data() const { return m_data; }  // the declarations after CONST, PERS or VAR
  const ProgramRoutines& routines() const { return m_routines; }        // the routines, with names in lower case

 private:
  void readNext();
  bool takeWord(std::string_view word);
  void skipSpace();
  void skipTo(std::string_view word);  // skips up to and including this word
  void skipBrackets();                 // skips brackets with their contents, if they come next
  std::string_view name();

  std::string m_text;
  std::size_t m_at = 0, m_line = 1;
  std::vector<ProgramStatement> m_data;
  ProgramRoutines m_routines;
};

}  // namespace handwheel
