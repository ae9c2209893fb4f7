// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/ProgramRoutines.h"

#include <deque>

namespace handwheel {

// Returns a name in lower case, as RAPID is not case-sensitive.
std::string folded(std::string_view name);

// A declaration of data in RAPID.
struct RapidData {
  ProgramStatement statement;  // without the words before the type
  std::string words;           // words before the type; empty: it is a parameter of a routine
};

// A scope of names in RAPID: a routine, a module, or what is known in all of them.
struct RapidScope {
  std::size_t outer = 0;  // number of the scope around it
  bool isRoutine = false;
};

// A RAPID module, split into declarations of data and the statements of its procedures. A statement may span several
// lines, and a line may contain several statements. Comments in procedures are statements that begin with "!". The head
// of a controller's backup and functions are omitted.
class RapidStatements {
 public:
  explicit RapidStatements(const std::vector<std::string_view>& lines);
  RapidStatements(const RapidStatements&) = delete;
  RapidStatements& operator=(const RapidStatements&) = delete;

  const std::vector<RapidData>& data() const { return m_data; }
  const std::vector<ProgramStatement>& comments() const { return m_comments; }  // the comments outside of procedures
  // The statements of traps and of handlers of errors, without their branches, and the conditions of these.
  const std::vector<ProgramStatement>& handlers() const { return m_handlers; }
  const std::vector<ProgramStatement>& conditions() const { return m_conditions; }
  const std::vector<std::size_t>& leftOut() const { return m_leftOut; }  // lines where functions and handlers begin
  // The scopes by the numbers that statements have. 0: data of the controller. 1: what all modules see.
  const std::vector<RapidScope>& scopes() const { return m_scopes; }
  const ProgramRoutines& routines() const { return m_routines; }  // the routines, with names in lower case

  static constexpr std::size_t kShared = 1;  // number of the scope of what all modules see

 private:
  void readNext();
  void endRoutine();
  bool readComment();     // reads a comment, if it comes next
  void skipBackupHead();  // skips %%% … %%%
  void readStatement(std::size_t line, const char* storage);
  void readRoutine(std::size_t line);
  void readRecord(std::size_t line);
  void beginScope(std::size_t outer, bool isRoutine);
  void beginHandler(std::size_t line);
  bool readBranch();  // reads the begin or end of a branch or loop in a handler, if it comes next
  void addComment(const ProgramStatement& comment);
  bool takeWord(std::string_view word);
  void skipSpace();
  void skipTo(std::string_view word);  // skips up to and including this word
  std::string_view skipBrackets();     // skips brackets, if they come next, and returns their contents
  std::string_view name();

  std::string m_text;
  std::size_t m_at = 0, m_line = 1;
  std::vector<RapidData> m_data;
  std::vector<ProgramStatement> m_comments;
  std::string m_prefix;  // TASK or LOCAL, which came before
  std::vector<ProgramStatement> m_handlers, m_conditions;
  std::vector<std::size_t> m_leftOut;
  std::deque<std::string> m_within;  // comments within statements
  std::vector<RapidScope> m_scopes{{}, {}};
  std::size_t m_module = kShared, m_scope = kShared;  // scopes of what comes next
  bool m_isHandler = false;
  std::size_t m_openRoutines = 0;
  bool m_hasOutside = false;  // true if there was a statement outside of procedures
  ProgramRoutines m_routines;
};

}  // namespace handwheel
