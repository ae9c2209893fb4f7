// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <cstdint>
#include <string_view>

namespace handwheel {

// A scanner that splits a text in memory into words and lines. Lines end with LF, CR LF or CR and are counted from 1. A
// UTF-8 byte order mark is skipped.
class TextScanner {
 public:
  struct Syntax {
    int comment = -1;       // a word that begins with this character hides the rest of its line
    int continuation = -1;  // this character joins two lines if only blanks stand between it and the line end
  };

  explicit TextScanner(std::string_view text) : TextScanner(text, Syntax()) {}
  TextScanner(std::string_view text, Syntax syntax);
  // Begins at a position within the text. line: the number of the line at this position.
  TextScanner(std::string_view text, std::size_t position, std::uint64_t line);

  // Returns the next word of the present line; empty at the end of the line.
  std::string_view word();
  // Returns the next word of the present or a later line; empty at the end of the text.
  std::string_view wordOnAnyLine();
  // Moves to the start of the next line. Returns false at the end of the text.
  bool nextLine();
  // Moves to the next line with a word unless the rest of the present line has one. Returns false at the end of the
  // text.
  bool findWord();

  // Returns the word that word() would return, without moving.
  std::string_view peek();
  // Moves back by a number of characters within the word that was read last.
  void stepBack(std::size_t characters) { m_at -= characters; }

  InputPosition inputPosition() const { return InputPosition::line(m_line); }
  std::size_t position() const { return static_cast<std::size_t>(m_at - m_begin); }

 private:
  bool isContinuation(const char* at) const;
  void skipBlanks();
  void skipLineEnd();

  const char* m_begin;
  const char* m_at;
  const char* m_end;
  std::uint64_t m_line = 1;
  Syntax m_syntax;
};

}  // namespace handwheel
