// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramScanner.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kLongestName = 80;

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

char capital(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

}  // namespace

void ProgramScanner::skip() {
  while (m_at < m_text.size()) {
    if (isBlank(m_text[m_at])) {
      ++m_at;
    } else if (m_text[m_at] == ';') {
      m_at = m_text.size();
    } else if (m_text[m_at] == '(') {
      const std::size_t end = m_text.find(')', m_at);
      if (end == std::string_view::npos)
        refuse({m_line, static_cast<std::uint32_t>(m_at + 1)}, "(", "the comment does not end in this line",
               "Close the comment with ).");
      m_at = end + 1;
    } else {
      return;
    }
  }
}

char ProgramScanner::peek() {
  skip();
  return m_at < m_text.size() ? capital(m_text[m_at]) : '\0';
}

bool ProgramScanner::takeIf(char c) {
  if (peek() != c) return false;
  ++m_at;
  return true;
}

bool ProgramScanner::takeIf(std::string_view word) {
  skip();
  if (m_text.size() - m_at < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (capital(m_text[m_at + i]) != word[i]) return false;
  m_at += word.size();
  return true;
}

int ProgramScanner::takeSkip(bool hasNumber) {
  if (!takeIf('/')) return 0;
  const char next = hasNumber ? peek() : '\0';
  if (next < '1' || next > '9') return 1;
  take();
  return next - '0';
}

bool ProgramScanner::nextIsLetter() {
  return isLetter(peek());
}

bool ProgramScanner::nextIsNumber() {
  return isDigit(peek()) || peek() == '.';
}

double ProgramScanner::number() {
  const SourceLocation begin = location();
  const std::size_t from = m_at;
  while (m_at < m_text.size() && (isDigit(m_text[m_at]) || m_text[m_at] == '.')) ++m_at;
  double value = 0.0;
  ErrorCode why;
  const std::string_view word = m_text.substr(from, m_at - from);
  if (word.empty() || word == "." || !parseDecimal(word, value, why) || !std::isfinite(value))
    refuse(begin, word.empty() ? token() : std::string(word), "a number is expected here",
           "Write a number such as 12.5.");
  return value;
}

std::string ProgramScanner::name() {
  const SourceLocation begin = location();
  expect('<', "Write the name in angle brackets.");
  std::string text;
  for (; m_at < m_text.size() && m_text[m_at] != '>'; ++m_at) {
    const char c = m_text[m_at];
    if (!isBlank(c)) text += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  if (m_at == m_text.size() || text.empty() || text.size() > kLongestName)
    refuse(begin, "<" + text, "this is not a name", "A name has 1 to 80 characters and ends with >.");
  ++m_at;
  return text;
}

void ProgramScanner::expect(char c, const char* remedy) {
  if (takeIf(c)) return;
  const std::string found = token();
  refuse(location(), found.empty() ? "end of the line" : found, std::string("'") + c + "' is expected here", remedy);
}

void ProgramScanner::expectEnd() {
  if (peek() == '\0') return;
  refuse(location(), token(), "nothing may follow here", "Put it into a line of its own.");
}

std::string ProgramScanner::commentFrom(std::size_t at) const {
  const std::size_t begin = m_text.find('(', at);
  const std::size_t end = begin == std::string_view::npos ? begin : m_text.find(')', begin);
  return end == std::string_view::npos ? std::string() : std::string(m_text.substr(begin + 1, end - begin - 1));
}

std::string ProgramScanner::lastComment() const {
  std::string last;
  for (std::size_t at = 0; at < m_text.size() && m_text[at] != ';'; ++at) {
    if (m_text[at] != '(') continue;
    last = commentFrom(at);
    at = std::min(m_text.find(')', at), m_text.size());
  }
  return last;
}

bool ProgramScanner::hasWords() {
  const std::size_t open = m_text.rfind('(');
  const bool isOpen = open != std::string_view::npos && m_text.find(')', open) == std::string_view::npos;
  return isOpen || peek() != '\0';
}

std::string ProgramScanner::rest() {
  std::string text;
  for (char c = peek(); c != '\0'; c = peek()) {
    text += c;
    take();
  }
  return text;
}

SourceLocation ProgramScanner::location() {
  skip();
  return {m_line, static_cast<std::uint32_t>(m_at + 1)};
}

std::string ProgramScanner::token() {
  skip();
  std::size_t end = m_at;
  if (end < m_text.size()) ++end;
  while (end < m_text.size() && (isDigit(m_text[end]) || m_text[end] == '.')) ++end;
  return std::string(m_text.substr(m_at, end - m_at));
}

}  // namespace handwheel
