// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramErrors.h"

#include <string_view>

namespace handwheel {

// Reads one line of a lathe program from left to right. Blanks and comments separate words and are skipped; letters
// are read as capitals. Whatever cannot be read is refused with its place (ProgramRefusal).
class ProgramScanner {
 public:
  ProgramScanner(std::string_view line, std::uint32_t number) : m_text(line), m_line(number) {}

  // The next character that counts; 0 at the end of the line.
  char peek();
  void take() { ++m_at; }
  bool takeIf(char c);
  // Takes these capital letters where they come next.
  bool takeIf(std::string_view word);
  bool nextIsLetter();

  // A decimal number without sign.
  double number();
  bool nextIsNumber();
  // What stands between < and >, in small letters without blanks.
  std::string name();

  void expect(char c, const char* remedy);
  void expectEnd();    // refuses what follows, comments aside
  bool hasWords();     // anything but comments follows, also one that does not end
  std::string rest();  // what follows, without blanks and comments, in capitals

  ProgramPlace place();                    // of the next character that counts
  std::string token();                     // there, for messages
  std::size_t at() const { return m_at; }  // bytes
  void seek(std::size_t at) { m_at = at; }

 private:
  void skip();

  std::string_view m_text;
  std::uint32_t m_line;
  std::size_t m_at = 0;
};

}  // namespace handwheel
