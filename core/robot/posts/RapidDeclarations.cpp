// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/RapidDeclarations.h"

#include "robot/posts/PostText.h"

namespace handwheel {

namespace {

// Returns the declared name in "num n:=1", "num a{3}", "part ENDRECORD"; in lower case.
std::string declaredName(const RapidData& data) {
  const std::string_view text = data.statement.text;
  LineReader line(text, 0);
  std::string name = folded(line.name());
  if (data.words.ends_with("RECORD ")) return name;
  if (!data.words.empty()) return folded(line.name());
  // A parameter: "\switch s", "VAR num n{*}"; the last word.
  LineReader words(text, 0);
  for (words.take("\\"); !words.rest().empty(); words.skipSpace()) {
    const std::string_view word = words.name();
    if (word.empty()) break;
    name = folded(word);
  }
  return name;
}

}  // namespace

RapidName RapidDeclarations::add(const RapidData& data, bool isNeeded) {
  const std::size_t scope = data.statement.scope;
  const bool isLocal = data.words.starts_with("LOCAL");
  const bool isInModule = scope >= m_scopes.size() || !m_scopes[scope].isRoutine;
  RapidName name{isInModule && !isLocal ? RapidStatements::kShared : scope, declaredName(data)};
  if (data.words.empty()) {
    m_numbers.emplace(name, m_all.size());
    m_all.push_back({data, name, {}, false});
    return name;
  }
  const auto [known, isNew] = m_numbers.emplace(name, m_all.size());
  if (!isNew) return name;
  std::string newName;
  for (int n = 2; !m_taken.insert(newName.empty() ? name.second : newName).second; ++n)
    newName = name.second + "_" + std::to_string(n);
  m_all.push_back({data, name, newName, isNeeded});
  return name;
}

RapidName RapidDeclarations::resolved(std::size_t scope, const std::string& name) const {
  for (; scope > 0 && scope < m_scopes.size(); scope = scope == RapidStatements::kShared ? 0 : m_scopes[scope].outer) {
    if (m_numbers.contains({scope, name})) return {scope, name};
  }
  return {0, name};
}

std::string RapidDeclarations::flattened(std::size_t scope, std::string_view text) {
  return withNames(text, [&](const std::string& name) {
    const auto declaration = m_numbers.find(resolved(scope, name));
    if (declaration == m_numbers.end()) return std::string();
    m_all[declaration->second].isNeeded = true;
    return m_all[declaration->second].newName;
  });
}

std::vector<ProgramLine> RapidDeclarations::needed() {
  std::vector<std::optional<ProgramLine>> lines(m_all.size());
  // A declaration may need others.
  for (bool isNew = true; isNew;) {
    isNew = false;
    for (std::size_t i = 0; i < m_all.size(); ++i) {
      if (!m_all[i].isNeeded || lines[i] || m_all[i].data.words.empty()) continue;
      const ProgramStatement& statement = m_all[i].data.statement;
      std::string text = m_all[i].data.words + flattened(statement.scope, statement.text);
      lines[i] = keptLine(ProgramLine::Kind::Declaration, text, statement.line);
      isNew = true;
    }
  }
  std::vector<ProgramLine> all;
  for (std::optional<ProgramLine>& line : lines) {
    if (line) all.push_back(std::move(*line));
  }
  return all;
}

}  // namespace handwheel
