// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/ProgramRoutines.h"

namespace handwheel {

// Returns a name in lower case, as RAPID is not case-sensitive.
std::string folded(std::string_view name);

// A declaration of data in RAPID.
struct RapidData {
  ProgramStatement statement;  // without the words before the type
  bool isLocal = false;
  std::string_view storage;  // CONST, PERS or VAR
};

// A RAPID module, split into declarations of data and the statements of its procedures. A statement may span several
// lines, and a line may contain several statements. Comments in procedures are statements that begin with "!". The head
// of a controller's backup, functions, traps and error handlers are omitted.
class RapidStatements {
 public:
  explicit RapidStatements(const std::vector<std::string_view>& lines);
  RapidStatements(const RapidStatements&) = delete;
  RapidStatements& operator=(const RapidStatements&) = delete;

  const std::vector<RapidData>& data() const { return m_data; }
  const std::vector<ProgramStatement>& comments() const { return m_comments; }  // the comments outside of procedures
  const ProgramRoutines& routines() const { return m_routines; }  // the routines, with names in lower case

 private:
  void readNext();
  void endRoutine();
  bool readComment();     // reads a comment, if it comes next
  void skipBackupHead();  // skips %%% … %%%
  void readStatement(std::size_t line, const char* storage);
  bool takeWord(std::string_view word);
  void skipSpace();
  void skipTo(std::string_view word);  // skips up to and including this word
  void skipBrackets();                 // skips brackets with their contents, if they come next
  std::string_view name();

  std::string m_text;
  std::size_t m_at = 0, m_line = 1;
  std::vector<RapidData> m_data;
  std::vector<ProgramStatement> m_comments;
  bool m_isLocal = false;  // LOCAL came before
  std::size_t m_openRoutines = 0;
  bool m_hasOutside = false;  // true if there was a statement outside of procedures
  ProgramRoutines m_routines;
};

}  // namespace handwheel
