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
  // Takes these capital letters if they come next.
  bool takeIf(std::string_view word);
  bool nextIsLetter();

  // Reads a decimal number without sign.
  double number();
  bool nextIsNumber();
  // Reads a name between < and >, in small letters without blanks.
  std::string name();

  void expect(char c, const char* remedy);
  void expectEnd();    // refuses anything but comments
  bool hasWords();     // anything but comments follows, also an unclosed comment
  std::string rest();  // the rest of the line, without blanks and comments, in capitals

  SourceLocation location();               // location of the next significant character
  std::string token();                     // token at that location, for messages
  std::size_t at() const { return m_at; }  // bytes
  void seek(std::size_t at) { m_at = at; }

 private:
  void skip();

  std::string_view m_text;
  std::uint32_t m_line;
  std::size_t m_at = 0;
};

}  // namespace handwheel
