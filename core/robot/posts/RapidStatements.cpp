// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/RapidStatements.h"

#include "robot/posts/PostText.h"

#include <algorithm>

namespace handwheel {

std::string folded(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

RapidStatements::RapidStatements(const std::vector<std::string_view>& lines) {
  for (const std::string_view line : lines) (m_text += line) += '\n';
  for (skipSpace(); m_at < m_text.size(); skipSpace()) readNext();
  std::replace(m_text.begin(), m_text.end(), '\n', ' ');  // within statements
}

void RapidStatements::readNext() {
  const std::size_t line = m_line;
  if (takeWord("LOCAL") || takeWord("TASK")) return;
  if (takeWord("MODULE")) {
    name();
    return skipBrackets();
  }
  if (takeWord("ENDMODULE")) return;
  if (takeWord("PROC")) {
    m_routines.begin(folded(name()), line);
    return skipBrackets();
  }
  if (takeWord("ENDPROC")) return m_routines.end();
  if (takeWord("FUNC")) return skipTo("ENDFUNC");
  if (takeWord("TRAP")) return skipTo("ENDTRAP");
  if (takeWord("RECORD")) return skipTo("ENDRECORD");
  if (takeWord("ERROR") || takeWord("UNDO") || takeWord("BACKWARD")) {
    skipTo("ENDPROC");
    return m_routines.end();
  }
  const bool isData = takeWord("CONST") || takeWord("PERS") || takeWord("VAR");
  skipSpace();
  const std::size_t begin = m_at;
  bool isQuoted = false;
  for (; m_at < m_text.size() && (m_text[m_at] != ';' || isQuoted); ++m_at) {
    if (m_text[m_at] == '"') isQuoted = !isQuoted;
    if (m_text[m_at] == '\n') ++m_line;
  }
  const std::string_view text = std::string_view(m_text).substr(begin, m_at - begin);
  if (m_at < m_text.size()) ++m_at;
  if (text.empty()) return;
  if (isData)
    m_data.push_back({text, line});
  else
    m_routines.add({text, line});
}

void RapidStatements::skipSpace() {
  for (; m_at < m_text.size() && std::string_view(" \t\r\n").find(m_text[m_at]) != std::string_view::npos; ++m_at) {
    if (m_text[m_at] == '\n') ++m_line;
  }
}

std::string_view RapidStatements::name() {
  skipSpace();
  LineReader rest(std::string_view(m_text).substr(m_at), m_line);
  const std::string_view found = rest.name();
  m_at += found.size();
  return found;
}

bool RapidStatements::takeWord(std::string_view word) {
  skipSpace();
  LineReader rest(std::string_view(m_text).substr(m_at), m_line);
  if (!rest.takeWord(word)) return false;
  m_at += word.size();
  return true;
}

void RapidStatements::skipTo(std::string_view word) {
  while (m_at < m_text.size() && !takeWord(word)) {
    if (name().empty() && m_at < m_text.size()) ++m_at;
  }
}

void RapidStatements::skipBrackets() {
  skipSpace();
  if (m_at >= m_text.size() || m_text[m_at] != '(') return;
  for (; m_at < m_text.size() && m_text[m_at] != ')'; ++m_at) {
    if (m_text[m_at] == '\n') ++m_line;
  }
  if (m_at < m_text.size()) ++m_at;
}

}  // namespace handwheel
