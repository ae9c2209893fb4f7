// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ProgramRoutines.h"

#include "robot/posts/PostText.h"

#include <set>

namespace handwheel {

namespace {

constexpr std::size_t kMostStatements = 10 * PostProcessor::kMostMotions;
// Limits the time, as a long statement in a repeated call is examined each time.
constexpr std::size_t kMostCharacters = 10 * PostProcessor::kLargestText;
constexpr std::size_t kDeepestCall = 64;

using Called = std::function<std::string(std::string_view)>;

}  // namespace

std::vector<ProgramStatement> statementsOf(const std::vector<std::string_view>& lines, std::string_view comment) {
  std::vector<ProgramStatement> all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = lines[i];
    bool isQuoted = false;
    std::size_t begin = 0;
    for (std::size_t k = 0; k <= line.size(); ++k) {
      if (k < line.size() && line[k] == '"') isQuoted = !isQuoted;
      const bool isComment = !comment.empty() && !isQuoted && line.substr(k).starts_with(comment);
      if (k < line.size() && !isComment && (line[k] != ';' || isQuoted)) continue;
      const std::string_view text = line.substr(begin, k - begin);
      if (text.find_first_not_of(" \t\r") != text.npos) all.push_back({text, i + 1});
      begin = k + 1;
      if (!isComment) continue;
      all.push_back({line.substr(k), i + 1, true});
      break;
    }
  }
  return all;
}

void ProgramRoutines::begin(std::string name, std::size_t line) {
  const auto [routine, isNew] = m_routines.try_emplace(std::move(name));
  routine->second = {line, {}, !isNew};
  m_open.push_back(&routine->second);
}

void ProgramRoutines::end() {
  if (!m_open.empty()) m_open.pop_back();
}

void ProgramRoutines::add(const ProgramStatement& statement) {
  m_hasOutside = m_hasOutside || (m_open.empty() && !statement.isComment);
  (m_open.empty() ? m_outside : m_open.back()->statements).push_back(statement);
}

Result<std::vector<ProgramStatement>> ProgramRoutines::unrolled(const std::string& first, const Called& called) const {
  std::vector<ProgramStatement> all;
  struct Frame {
    const std::vector<ProgramStatement>* statements;
    std::size_t next = 0;
  };
  std::vector<Frame> open;
  if (!m_hasOutside && !m_routines.empty()) all = m_outside;
  if (m_hasOutside || m_routines.empty()) {
    open.push_back({&m_outside});
  } else if (const auto main = m_routines.find(first); main != m_routines.end()) {
    if (main->second.isTwice)
      return LineReader({}, main->second.line).malformed("program", "it does not specify which routine is the first");
    open.push_back({&main->second.statements});
  } else {
    std::set<std::string> free;
    for (const auto& [name, routine] : m_routines) free.insert(name);
    for (const auto& [name, routine] : m_routines) {
      for (const ProgramStatement& each : routine.statements) free.erase(called(each.text));
    }
    if (free.size() != 1)
      return LineReader({}, m_routines.begin()->second.line)
          .malformed("program", "it does not specify which routine is the first");
    open.push_back({&m_routines.at(*free.begin()).statements});
  }
  std::size_t steps = 0, characters = 0;  // also of calls that lead to nothing
  while (!open.empty()) {
    Frame& frame = open.back();
    if (frame.next == frame.statements->size()) {
      open.pop_back();
      continue;
    }
    const ProgramStatement& statement = (*frame.statements)[frame.next++];
    const std::string name = called(statement.text);
    const auto routine = name.empty() ? m_routines.end() : m_routines.find(name);
    if (routine == m_routines.end()) {
      all.push_back(statement);
    } else {
      // Every recursion gets there.
      if (open.size() >= kDeepestCall)
        return LineReader({}, statement.line).malformed("program", "routines call each other endlessly");
      if (routine->second.isTwice)
        return LineReader({}, statement.line).malformed("program", "two routines have the name that it calls");
      open.push_back({&routine->second.statements});
    }
    characters += statement.text.size();
    if (++steps > kMostStatements || characters > kMostCharacters)
      return LineReader({}, statement.line).malformed("program", "there are too many motions");
  }
  return all;
}

}  // namespace handwheel
