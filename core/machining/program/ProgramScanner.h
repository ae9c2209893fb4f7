// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramErrors.h"

#include <string_view>

namespace handwheel {

// Reads one line of a lathe program from left to right. Blanks and comments separate words and are skipped; letters are
// read as capitals. Text that cannot be read is refused with its location (ProgramRefusal).
class ProgramScanner {
 public:
  ProgramScanner(std::string_view line, std::uint32_t number) : m_text(line), m_line(number) {}

  // Returns the next significant character; 0 at the end of the line.
  char peek();
  void take() { ++m_at; }
  bool takeIf(char c);
  // Takes a word in capital letters if it comes next.
  bool takeIf(std::string_view word);
  bool nextIsLetter();

  // Takes a block skip, a / with a digit from 1 to 9 if it may have one. Returns the digit, 1 for a bare /; 0: none.
  int takeSkip(bool hasNumber);

  // Reads a decimal number without a sign.
  double number();
  bool nextIsNumber();
  // Reads a name between < and >. The name is returned in small letters and without blanks.
  std::string name();

  void expect(char c, const char* remedy);
  void expectEnd();                               // refuses anything but comments
  std::string commentFrom(std::size_t at) const;  // first comment from a position on, without brackets; empty: none
  std::string lastComment() const;                // last comment of the line, without brackets; empty: none
  bool hasWords();                                // true if anything but comments follows; an unclosed comment counts
  std::string rest();                             // the rest of the line, without blanks and comments, in capitals

  SourceLocation location();               // location of the next significant character
  std::string token();                     // token at location(), for messages
  std::size_t at() const { return m_at; }  // position in the line, in bytes
  void seek(std::size_t at) { m_at = at; }

 private:
  void skip();

  std::string_view m_text;
  std::uint32_t m_line;
  std::size_t m_at = 0;
};

}  // namespace handwheel
