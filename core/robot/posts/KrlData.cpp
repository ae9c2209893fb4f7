// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/KrlData.h"

#include "robot/posts/PostText.h"

namespace handwheel {

namespace {

// Skips the words before the type of a declaration. Returns false if there are none.
bool takePrefixes(LineReader& line) {
  bool isDeclared = false;
  for (bool isWord = true; isWord; isDeclared = isDeclared || isWord)
    isWord = line.takeWord("DECL") || line.takeWord("GLOBAL") || line.takeWord("CONST");
  return isDeclared;
}

// Returns a text without its braces and their contents, and without quotes and theirs.
std::string withoutValues(std::string_view text) {
  std::string plain;
  int depth = 0;
  bool isQuoted = false;
  for (const char c : text) {
    if (c == '"') isQuoted = !isQuoted;
    if (c == '{' && !isQuoted) ++depth;
    if (depth == 0 && !isQuoted && c != '"') plain += c;
    if (c == '}' && !isQuoted) --depth;
  }
  return plain;
}

// Returns the names of "INT A,B[3],C=1" after the type.
std::vector<std::string> declaredNames(std::string_view text) {
  const std::string plain = withoutValues(text);
  std::vector<std::string> names;
  for (const std::string_view part : argumentsOf(plain)) {
    if (std::string name = lowerCase(std::string(LineReader(part, 0).name())); !name.empty())
      names.push_back(std::move(name));
  }
  return names;
}

}  // namespace

KrlData::KrlData(std::string_view text) {
  bool isOwn = true;  // $config.dat is on the controller, whatever the program
  while (!text.empty()) {
    const std::string_view whole = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(whole.size() + 1, text.size()));
    const std::string_view line = whole.substr(0, whole.find(';'));
    read(line);
    LineReader words(line, 0);
    if (words.takeWord("DEFDAT")) isOwn = !words.take("$");
    if (isOwn) readOwn(line);
  }
}

void KrlData::read(std::string_view text) {
  LineReader line(text, 0);
  const bool isDeclared = takePrefixes(line);
  LineReader typed = line;
  const bool isSignal = typed.takeWord("SIGNAL");
  const std::string_view type = isSignal ? std::string_view("SIGNAL") : typed.name();
  const bool isBasic = LineReader(type, 0).takeWord("INT") || LineReader(type, 0).takeWord("REAL") ||
                       LineReader(type, 0).takeWord("BOOL") || LineReader(type, 0).takeWord("CHAR");
  bool isPosition = false;
  for (const char* const position : {"E6AXIS", "AXIS", "E6POS", "POS", "FRAME"})
    isPosition = isPosition || line.takeWord(position);
  if (!isDeclared && !isSignal && !isBasic && !isPosition) return;
  for (std::string& each : declaredNames(typed.rest())) (isSignal ? m_signals : m_declared).insert(std::move(each));
  const std::string name = lowerCase(std::string(line.name()));
  if (!isPosition || name.empty() || !line.take("=")) return;
  line.skipSpace();
  const std::size_t end = line.rest().find('}');
  if (!line.rest().starts_with('{') || end == std::string_view::npos) return;
  const std::string value(line.rest().substr(0, end + 1));
  const auto [known, isNew] = m_values.emplace(name, value);
  if (!isNew && known->second != value) known->second.clear();
}

void KrlData::readOwn(std::string_view text) {
  LineReader line(text, 0);
  const bool isDeclared = takePrefixes(line);
  const bool isSignal = LineReader(line).takeWord("SIGNAL"),
             isType = LineReader(line).takeWord("STRUC") || LineReader(line).takeWord("ENUM");
  LineReader typed = line;
  const std::string type(typed.name());
  LineReader value = typed;
  const std::string_view first = value.name();
  const std::string name = lowerCase(std::string(first.empty() ? std::string_view(type) : first));
  if (isSignal || isType) {
    m_own[name].declaration = keptLine(ProgramLine::Kind::Declaration, line.rest(), 0).text;
    return;
  }
  if (first.empty()) {  // "A[1]=5" gives an array of the data a value
    if (const auto known = m_own.find(name); known != m_own.end())
      known->second.values.push_back(keptLine(ProgramLine::Kind::Statement, text, 0).text);
    return;
  }
  if (!isDeclared && !m_declared.contains(name)) return;
  // Each part "N=1" is declared as "N", and assigned.
  std::string_view rest = typed.rest();
  int depth = 0;
  bool isQuoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= rest.size(); ++i) {
    if (i < rest.size() && rest[i] == '"') isQuoted = !isQuoted;
    if (i < rest.size() && !isQuoted)
      depth += rest[i] == '{' || rest[i] == '[' ? 1 : rest[i] == '}' || rest[i] == ']' ? -1 : 0;
    if (i < rest.size() && (rest[i] != ',' || depth != 0 || isQuoted)) continue;
    const std::string part = keptLine(ProgramLine::Kind::Statement, rest.substr(begin, i - begin), 0).text;
    begin = i + 1;
    const std::size_t sign = part.find('=');
    const std::string called = lowerCase(std::string(LineReader(part, 0).name()));
    if (called.empty()) continue;
    m_own[called] = {"DECL " + type + " " + part.substr(0, sign), {}};
    if (sign != part.npos) m_own[called].values.push_back(part);
  }
}

std::optional<std::string_view> KrlData::valueOf(std::string_view name) const {
  const auto found = m_values.find(lowerCase(std::string(name)));
  if (found == m_values.end() || found->second.empty()) return std::nullopt;
  return found->second;
}

bool KrlData::maySwitch(std::string_view name) const {
  const std::string lower = lowerCase(std::string(name));
  return m_signals.contains(lower) || !m_declared.contains(lower);
}

std::vector<ProgramLine> KrlData::neededBy(const std::vector<ProgramLine>& lines) const {
  std::vector<std::string> open;
  std::set<std::string> seen;
  const auto add = [&](std::string_view text) {
    for (std::string& name : namesIn(text)) {
      if (m_own.contains(name) && seen.insert(name).second) open.push_back(std::move(name));
    }
  };
  // Declarations of the program hide the data.
  for (const ProgramLine& line : lines) {
    if (line.kind != ProgramLine::Kind::Declaration) continue;
    LineReader words(line.text, 0);
    takePrefixes(words);
    words.name();
    for (std::string& name : declaredNames(words.rest())) seen.insert(std::move(name));
  }
  for (const ProgramLine& line : lines) {
    if (line.kind != ProgramLine::Kind::Comment) add(line.text);
  }
  std::vector<ProgramLine> needed, values;
  for (std::size_t i = 0; i < open.size(); ++i) {  // grows within
    const Own& own = m_own.at(open[i]);
    needed.push_back({ProgramLine::Kind::Declaration, own.declaration});
    add(own.declaration);
    for (const std::string& value : own.values) {
      values.push_back({ProgramLine::Kind::Statement, value});
      add(value);
    }
  }
  std::ranges::reverse(needed);  // types before what is of them
  needed.insert(needed.end(), values.begin(), values.end());
  return needed;
}

bool KrlData::isHome(std::string_view name) {
  const std::string lower = lowerCase(std::string(name));
  return lower == "xhome" || lower == "home";
}

}  // namespace handwheel
