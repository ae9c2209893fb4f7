// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/TextScanner.h"

#include <algorithm>

namespace handwheel {

namespace {

bool isLineEnd(char c) {
  return c == '\n' || c == '\r';
}
bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

}  // namespace

TextScanner::TextScanner(std::string_view text, Syntax syntax)
    : m_begin(text.data()), m_at(m_begin), m_end(m_begin + text.size()), m_syntax(syntax) {
  if (text.starts_with("\xEF\xBB\xBF")) m_at += 3;
}

TextScanner::TextScanner(std::string_view text, std::size_t position, std::uint64_t line)
    : m_begin(text.data()), m_at(m_begin + position), m_end(m_begin + text.size()), m_line(line) {}

std::string_view TextScanner::word() {
  skipBlanks();
  const char* start = m_at;
  if (m_at == m_end || static_cast<unsigned char>(*m_at) == m_syntax.comment) return {};
  while (m_at != m_end && !isLineEnd(*m_at) && !isBlank(*m_at) && !isContinuation(m_at)) ++m_at;
  return {start, static_cast<std::size_t>(m_at - start)};
}

std::string_view TextScanner::wordOnAnyLine() {
  return findWord() ? word() : std::string_view();
}

std::string_view TextScanner::peek() {
  skipBlanks();
  const TextScanner start = *this;
  const std::string_view next = word();
  *this = start;
  return next;
}

bool TextScanner::nextLine() {
  skipBlanks();
  const bool inComment = m_at != m_end && static_cast<unsigned char>(*m_at) == m_syntax.comment;
  for (; m_at != m_end; ++m_at) {
    // A comment is not continued: a Windows path at its end would swallow the statement on the next line.
    if (!inComment && isContinuation(m_at)) {
      skipBlanks();
      if (m_at == m_end) return false;
    }
    if (isLineEnd(*m_at)) {
      skipLineEnd();
      return m_at != m_end;
    }
  }
  return false;
}

bool TextScanner::findWord() {
  for (;;) {
    skipBlanks();
    if (m_at == m_end) return false;
    if (!isLineEnd(*m_at) && static_cast<unsigned char>(*m_at) != m_syntax.comment) return true;
    if (!nextLine()) return false;
  }
}

bool TextScanner::isContinuation(const char* at) const {
  if (static_cast<unsigned char>(*at) != m_syntax.continuation) return false;
  const char* const end = std::find_if_not(at + 1, m_end, isBlank);
  return end != m_end && isLineEnd(*end);
}

void TextScanner::skipBlanks() {
  for (;;) {
    while (m_at != m_end && isBlank(*m_at)) ++m_at;
    if (m_at == m_end || !isContinuation(m_at)) return;
    m_at = std::find_if(m_at, m_end, isLineEnd);
    skipLineEnd();
  }
}

void TextScanner::skipLineEnd() {
  const bool carriageReturn = *m_at++ == '\r';
  if (carriageReturn && m_at != m_end && *m_at == '\n') ++m_at;
  ++m_line;
}

}  // namespace handwheel
