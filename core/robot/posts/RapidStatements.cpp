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
  const ProgramStatement comment{std::string_view(m_text).substr(m_at, end - m_at), m_line, true, m_scope};
  m_at = end;
  addComment(comment);
  return true;
}

void RapidStatements::addComment(const ProgramStatement& comment) {
  if (m_isHandler) return;
  if (m_openRoutines > 0 || m_hasOutside)
    m_routines.add(comment);
  else
    m_comments.push_back(comment);
}

void RapidStatements::beginScope(std::size_t outer, bool isRoutine) {
  m_scopes.push_back({outer, isRoutine});
  m_scope = m_scopes.size() - 1;
}

void RapidStatements::beginHandler(std::size_t line) {
  m_leftOut.push_back(line);
  m_isHandler = true;
  skipBrackets();
}

bool RapidStatements::readBranch() {
  const std::size_t line = m_line;
  for (const char* const word : {"ELSE", "ENDIF", "ENDTEST", "ENDFOR", "ENDWHILE", "DEFAULT"}) {
    if (!takeWord(word)) continue;
    if (m_at < m_text.size() && m_text[m_at] == ':') ++m_at;
    return true;
  }
  const std::size_t begin = m_at;
  const char* const end = takeWord("IF") || takeWord("ELSEIF")   ? "THEN"
                          : takeWord("WHILE") || takeWord("FOR") ? "DO"
                          : takeWord("CASE")                     ? ":"
                          : takeWord("TEST")                     ? "CASE"
                                                                 : nullptr;
  if (!end) return false;
  for (skipSpace(); m_at < m_text.size() && m_text[m_at] != ';'; skipSpace()) {
    const std::string_view rest = std::string_view(m_text).substr(m_at);
    const bool isEnd = *end == ':' ? rest.starts_with(':') : LineReader(rest, 0).takeWord(end);
    if (isEnd) {
      m_conditions.push_back({std::string_view(m_text).substr(begin, m_at - begin), line, false, m_scope});
      if (std::string_view(end) != "CASE") m_at += std::string_view(end).size();
      return true;
    }
    if (rest.starts_with('!'))
      m_at = std::min(m_text.find('\n', m_at), m_text.size());
    else if (name().empty())
      ++m_at;
  }
  m_at = begin;  // "IF condition instruction;"
  m_line = line;
  return false;
}

void RapidStatements::readNext() {
  if (readComment() || (m_isHandler && readBranch())) return;
  const std::size_t line = m_line;
  for (const char* const prefix : {"TASK", "LOCAL"}) {
    if (!takeWord(prefix)) continue;
    m_prefix += std::string(prefix) + " ";
    return;
  }
  if (takeWord("MODULE")) {
    name();
    skipBrackets();
    beginScope(kShared, false);
    m_module = m_scope;
    return;
  }
  if (takeWord("ENDMODULE")) {
    m_module = m_scope = kShared;
    return;
  }
  if (takeWord("PROC")) return readRoutine(line);
  if (takeWord("ENDPROC") || takeWord("ENDTRAP")) return endRoutine();
  if (takeWord("FUNC")) {
    m_leftOut.push_back(line);
    m_prefix.clear();
    return skipTo("ENDFUNC");
  }
  if (takeWord("TRAP")) {
    m_prefix.clear();
    name();
    beginScope(m_module, true);
    return beginHandler(line);
  }
  if (takeWord("RECORD")) return readRecord(line);
  if (takeWord("ERROR") || takeWord("UNDO") || takeWord("BACKWARD")) return beginHandler(line);
  for (const char* const storage : {"CONST", "PERS", "VAR"}) {
    if (takeWord(storage)) return readStatement(line, storage);
  }
  readStatement(line, nullptr);
}

void RapidStatements::readRoutine(std::size_t line) {
  m_routines.begin(folded(name()), line);
  m_prefix.clear();
  ++m_openRoutines;
  beginScope(m_module, true);
  for (const std::string_view parameter : argumentsOf(skipBrackets())) {
    if (parameter.find_first_not_of(" \t\n") != parameter.npos)
      m_data.push_back({{parameter, line, false, m_scope}, {}});
  }
}

void RapidStatements::readRecord(std::size_t line) {
  skipSpace();
  const std::size_t begin = m_at;
  skipTo("ENDRECORD");
  for (std::size_t i = begin; i < m_at; ++i) {
    for (bool isComment = m_text[i] == '!'; isComment && m_text[i] != '\n'; ++i) m_text[i] = ' ';
  }
  m_data.push_back(
      {{std::string_view(m_text).substr(begin, m_at - begin), line, false, m_module}, m_prefix + "RECORD "});
  m_prefix.clear();
}

void RapidStatements::endRoutine() {
  if (m_openRoutines > 0) {
    m_routines.end();
    --m_openRoutines;
  }
  m_isHandler = false;
  m_scope = m_module;
}

void RapidStatements::readStatement(std::size_t line, const char* storage) {
  skipSpace();
  const std::size_t begin = m_at;
  bool isQuoted = false;
  for (; m_at < m_text.size() && (m_text[m_at] != ';' || isQuoted); ++m_at) {
    if (m_text[m_at] == '"') isQuoted = !isQuoted;
    if (m_text[m_at] == '!' && !isQuoted) {  // a comment within the statement
      const std::size_t end = std::min(m_text.find('\n', m_at), m_text.size());
      m_within.push_back(m_text.substr(m_at, end - m_at));
      addComment({m_within.back(), m_line, true, m_scope});
      std::fill(m_text.begin() + static_cast<std::ptrdiff_t>(m_at), m_text.begin() + static_cast<std::ptrdiff_t>(end),
                ' ');
      m_at = end;
    }
    if (m_at < m_text.size() && m_text[m_at] == '\n') {
      ++m_line;
      isQuoted = false;
    }
  }
  m_at = std::min(m_at, m_text.size());
  const std::string_view text = std::string_view(m_text).substr(begin, m_at - begin);
  if (m_at < m_text.size()) ++m_at;
  const std::string prefix = std::exchange(m_prefix, {});
  if (text.empty()) return;
  const ProgramStatement statement{text, line, false, m_scope};
  if (storage) {
    m_data.push_back({statement, prefix + storage + " "});
  } else if (m_isHandler) {
    m_handlers.push_back(statement);
  } else {
    m_hasOutside = m_hasOutside || m_openRoutines == 0;
    m_routines.add(statement);
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

std::string_view RapidStatements::skipBrackets() {
  skipSpace();
  if (m_at >= m_text.size() || m_text[m_at] != '(') return {};
  const std::size_t begin = m_at + 1;
  for (; m_at < m_text.size() && m_text[m_at] != ')'; ++m_at) {
    if (m_text[m_at] == '\n') ++m_line;
  }
  const std::string_view contents = std::string_view(m_text).substr(begin, m_at - begin);
  if (m_at < m_text.size()) ++m_at;
  return contents;
}

}  // namespace handwheel
