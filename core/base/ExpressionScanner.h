// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace handwheel {

// A scanner for the text of arithmetic expressions. It is a part of Expression.cpp. Operators and blanks that are not
// ASCII, as in copied text, are treated as their ASCII equivalents.
class ExpressionScanner {
 public:
  explicit ExpressionScanner(std::string_view text) : m_text(text) {}

  std::size_t at() const { return m_at; }  // position in the text, bytes
  bool atEnd() const { return m_at == m_text.size(); }
  std::size_t column(std::size_t at) const;  // column of a byte position, from 1, in characters

  // Returns the next character that is not blank, or 0 at the end of the text.
  char sign();
  void skipSign();
  void skipBlanks();

  // Returns the next word without skipping it. A word consists of letters and of characters that are neither ASCII nor
  // operators, or it is a quotation mark, which means inches. The result may be empty.
  std::string_view peekWord();
  void skip(std::size_t bytes) { m_at += bytes; }

  // Returns the word or character at the current position, for error messages.
  std::string_view peekToken();

  // A number with a point or a comma as decimal sign. It is not well formed if it has two decimal signs or no digit.
  struct Number {
    std::string_view word;
    bool wellFormed = false;
    bool perhapsThousands = false;  // true for a number that may have a thousands separator: "1,234"
  };
  Number number();

 private:
  char peek() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }
  std::size_t skipDigits();
  void skipExponent();

  std::string_view m_text;
  std::size_t m_at = 0;
};

}  // namespace handwheel
