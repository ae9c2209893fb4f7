// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/RapidStatements.h"

#include "robot/posts/PostText.h"

#include <algorithm>
#include <utility>

namespace handwheel {

std::string folded(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

RapidStatements::RapidStatements(const std::vector<std::string_view>& lines) {
  for (const std::string_view line : lines) (m_text += line) += '\n';
  skipBackupHead();
  for (skipSpace(); m_at < m_text.size(); skipSpace()) readNext();
  std::replace(m_text.begin(), m_text.end(), '\n', ' ');  // within statements
}

void RapidStatements::skipBackupHead() {
  constexpr std::string_view kBorder = "%%%";
  skipSpace();
  if (!std::string_view(m_text).substr(m_at).starts_with(kBorder)) return;
  const std::size_t end = m_text.find(kBorder, m_at + kBorder.size());
  const std::size_t next = end == std::string::npos ? m_text.size() : end + kBorder.size();
  m_line += static_cast<std::size_t>(std::count(m_text.begin() + static_cast<std::ptrdiff_t>(m_at),
                                                m_text.begin() + static_cast<std::ptrdiff_t>(next), '\n'));
  m_at = next;
}

bool RapidStatements::readComment() {
  if (m_text[m_at] != '!') return false;
  const std::size_t end = std::min(m_text.find('\n', m_at), m_text.size());
  const ProgramStatement comment{std::string_view(m_text).substr(m_at, end - m_at), m_line, true};
  m_at = end;
  if (m_openRoutines > 0 || m_hasOutside)
    m_routines.add(comment);
  else
    m_comments.push_back(comment);
  return true;
}

void RapidStatements::readNext() {
  if (readComment()) return;
  const std::size_t line = m_line;
  if (takeWord("TASK")) return;
  if (takeWord("LOCAL")) {
    m_isLocal = true;
    return;
  }
  if (takeWord("MODULE")) {
    name();
    return skipBrackets();
  }
  if (takeWord("ENDMODULE")) return;
  if (takeWord("PROC")) {
    m_routines.begin(folded(name()), line);
    m_isLocal = false;
    ++m_openRoutines;
    return skipBrackets();
  }
  if (takeWord("ENDPROC")) return endRoutine();
  if (takeWord("FUNC")) return skipTo("ENDFUNC");
  if (takeWord("TRAP")) return skipTo("ENDTRAP");
  if (takeWord("RECORD")) return skipTo("ENDRECORD");
  if (takeWord("ERROR") || takeWord("UNDO") || takeWord("BACKWARD")) {
    skipTo("ENDPROC");
    return endRoutine();
  }
  for (const char* const storage : {"CONST", "PERS", "VAR"}) {
    if (takeWord(storage)) return readStatement(line, storage);
  }
  readStatement(line, nullptr);
}

void RapidStatements::endRoutine() {
  m_routines.end();
  if (m_openRoutines > 0) --m_openRoutines;
}

void RapidStatements::readStatement(std::size_t line, const char* storage) {
  skipSpace();
  const std::size_t begin = m_at;
  bool isQuoted = false;
  for (; m_at < m_text.size() && (m_text[m_at] != ';' || isQuoted); ++m_at) {
    if (m_text[m_at] == '"') isQuoted = !isQuoted;
    for (; m_at < m_text.size() && m_text[m_at] == '!' && !isQuoted;) {  // a comment within the statement
      for (; m_at < m_text.size() && m_text[m_at] != '\n'; ++m_at) m_text[m_at] = ' ';
    }
    if (m_at < m_text.size() && m_text[m_at] == '\n') {
      ++m_line;
      isQuoted = false;
    }
  }
  m_at = std::min(m_at, m_text.size());
  const std::string_view text = std::string_view(m_text).substr(begin, m_at - begin);
  if (m_at < m_text.size()) ++m_at;
  const bool isLocal = std::exchange(m_isLocal, false);
  if (text.empty()) return;
  if (storage) {
    m_data.push_back({{text, line}, isLocal, storage});
  } else {
    m_hasOutside = m_hasOutside || m_openRoutines == 0;
    m_routines.add({text, line});
  }
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
    if (m_at < m_text.size() && m_text[m_at] == '!')
      m_at = std::min(m_text.find('\n', m_at), m_text.size());
    else if (name().empty() && m_at < m_text.size())
      ++m_at;
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
