// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace handwheel {

// A scanner for the text of arithmetic expressions; part of Expression.cpp. Operators and blanks that are not ASCII, as
// copied from a text, are treated as their ASCII equivalents.
class ExpressionScanner {
 public:
  explicit ExpressionScanner(std::string_view text) : m_text(text) {}

  std::size_t at() const { return m_at; }  // in bytes
  bool atEnd() const { return m_at == m_text.size(); }
  std::size_t column(std::size_t at) const;  // column of a byte position, from 1, in characters

  // Returns the next character that is not blank; 0 at the end.
  char sign();
  void skipSign();
  void skipBlanks();

  // Returns the next word without skipping it. It consists of letters and of characters that are neither ASCII nor
  // operators, or it is a quotation mark, which means inches. May be empty.
  std::string_view peekWord();
  void skip(std::size_t bytes) { m_at += bytes; }

  // Returns the token at the current position, for error messages: a word or a character.
  std::string_view peekToken();

  // A number with either decimal sign; not well formed when it has two of them or no digit.
  struct Number {
    std::string_view word;
    bool wellFormed = false;
    bool perhapsThousands = false;  // "1,234"
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
