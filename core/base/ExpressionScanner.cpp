// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ExpressionScanner.h"

#include "base/NumberText.h"

#include <algorithm>

namespace handwheel {

namespace {

struct Sign {
  std::string_view spelling;
  char meaning;
};

constexpr Sign kSigns[] = {{"\u00d7", '*'}, {"\u00b7", '*'}, {"\u00f7", '/'}, {"\u2212", '-'},
                           {"\u00a0", ' '}, {"\u2009", ' '}, {"\u202f", ' '}};

bool isAscii(char c) {
  return static_cast<unsigned char>(c) < 0x80u;
}

bool continuesCharacter(char c) {
  return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u;  // continuation byte of UTF-8
}

// Returns the non-ASCII operator or blank at the beginning of the text; else null.
const Sign* foreignSign(std::string_view text) {
  const auto* found = std::find_if(std::begin(kSigns), std::end(kSigns),
                                   [text](const Sign& s) { return text.starts_with(s.spelling); });
  return found == std::end(kSigns) ? nullptr : found;
}

}  // namespace

std::size_t ExpressionScanner::column(std::size_t at) const {
  const auto characters = std::count_if(m_text.begin(), m_text.begin() + static_cast<std::ptrdiff_t>(at),
                                        [](char c) { return !continuesCharacter(c); });
  return static_cast<std::size_t>(characters) + 1;
}

char ExpressionScanner::sign() {
  skipBlanks();
  const Sign* foreign = foreignSign(m_text.substr(m_at));
  return foreign ? foreign->meaning : peek();
}

void ExpressionScanner::skipSign() {
  const Sign* foreign = foreignSign(m_text.substr(m_at));
  m_at += foreign ? foreign->spelling.size() : 1;
}

void ExpressionScanner::skipBlanks() {
  for (;;) {
    const Sign* foreign = foreignSign(m_text.substr(m_at));
    if (peek() != ' ' && peek() != '\t' && !(foreign && foreign->meaning == ' ')) return;
    skipSign();
  }
}

std::string_view ExpressionScanner::peekWord() {
  if (peek() == '"') return m_text.substr(m_at, 1);
  std::size_t end = m_at;
  while (end < m_text.size() &&
         (isLetter(m_text[end]) || (!isAscii(m_text[end]) && !foreignSign(m_text.substr(end))))) {
    ++end;
  }
  return m_text.substr(m_at, end - m_at);
}

std::string_view ExpressionScanner::peekToken() {
  if (const Sign* foreign = foreignSign(m_text.substr(m_at))) return foreign->spelling;
  const std::string_view word = peekWord();
  return word.empty() ? m_text.substr(m_at, 1) : word;
}

ExpressionScanner::Number ExpressionScanner::number() {
  const std::size_t start = m_at;
  const std::size_t whole = skipDigits();
  const bool comma = peek() == ',';
  if (comma || peek() == '.') ++m_at;
  const std::size_t fraction = skipDigits();
  const std::size_t mantissa = m_at;
  skipExponent();
  Number result;
  result.wellFormed = whole + fraction > 0 && peek() != '.' && peek() != ',';
  result.perhapsThousands =
      comma && whole >= 1 && whole <= 3 && m_text[start] != '0' && fraction == 3 && m_at == mantissa;
  if (!result.wellFormed) {
    while (isDigit(peek()) || peek() == '.' || peek() == ',') ++m_at;
  }
  result.word = m_text.substr(start, m_at - start);
  return result;
}

std::size_t ExpressionScanner::skipDigits() {
  const std::size_t start = m_at;
  while (isDigit(peek())) ++m_at;
  return m_at - start;
}

// Skips an exponent only if digits follow: the e of "2 em" is none.
void ExpressionScanner::skipExponent() {
  if (peek() != 'e' && peek() != 'E') return;
  const std::size_t start = m_at++;
  if (peek() == '+' || peek() == '-') ++m_at;
  if (skipDigits() == 0) m_at = start;
}

}  // namespace handwheel
