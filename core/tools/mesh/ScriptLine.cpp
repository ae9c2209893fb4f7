// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/ScriptLine.h"

#include "base/NumberText.h"
#include "tools/mesh/ScriptErrors.h"

#include <charconv>
#include <cmath>

namespace handwheel {
namespace {

constexpr std::size_t kLongestQuote = 40;  // characters of a word that a sentence repeats

std::string inQuotes(std::string_view word) {
  const bool isLong = word.size() > kLongestQuote;
  return "'" + std::string(word.substr(0, kLongestQuote)) + (isLong ? "…'" : "'");
}

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && !isBlank(text[end])) ++end;
    if (end > at) words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

bool readIndex(std::string_view word, std::uint32_t& index) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  return !word.empty() && error == std::errc() && end == word.data() + word.size();
}

bool readNumber(std::string_view word, double& value) {
  ErrorCode why{};
  return parseDecimal(word, value, why) && std::isfinite(value);
}

}  // namespace

ScriptLineWriter& ScriptLineWriter::word(std::string_view word) {
  m_text += ' ';
  m_text += word;
  return *this;
}

ScriptLineWriter& ScriptLineWriter::options(const OperationValues& values) {
  const std::string line = optionLine(values);
  return line.empty() ? *this : word(line);
}

std::string listText(const std::vector<std::uint32_t>& numbers) {
  std::string text;
  for (const std::uint32_t n : numbers) text += (text.empty() ? "" : ",") + std::to_string(n);
  return text;
}

std::string pairsText(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
  std::string text;
  for (const auto& [a, b] : pairs) text += (text.empty() ? "" : ",") + std::to_string(a) + ":" + std::to_string(b);
  return text;
}

std::string rangesText(const FaceSelection& faces) {
  std::string text;
  std::optional<std::pair<Face, Face>> run;
  const auto close = [&] {
    if (!run) return;
    text += (text.empty() ? "" : ",") + std::to_string(run->first);
    if (run->second > run->first) text += "-" + std::to_string(run->second);
  };
  faces.forEach([&](Face f) {
    if (run && run->second + 1 == f) {
      run->second = f;
      return;
    }
    close();
    run = {f, f};
  });
  close();
  return text;
}

std::string pointText(const Vec3& p) {
  return shortestText(p.x()) + "," + shortestText(p.y()) + "," + shortestText(p.z());
}

ScriptLineReader::ScriptLineReader(std::string_view text) {
  const std::vector<std::string_view> words = wordsOf(text);
  if (words.empty()) {
    complain("it is empty");
    return;
  }
  m_verb = words.front();
  if (words.size() > 1) m_line = text.substr(static_cast<std::size_t>(words[1].data() - text.data()));
  while (!m_line.empty() && isBlank(m_line.back())) m_line.pop_back();
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (!words[i].starts_with("--")) {
      m_words.emplace_back(words[i]);
      continue;
    }
    const std::string_view name = words[i].substr(2, words[i].find('=') - 2);
    if (find(name)) complain("--" + std::string(name) + " is given twice");
    Option option{std::string(name), std::nullopt};
    if (words[i].size() > 2 + name.size()) {
      option.value = words[i].substr(3 + name.size());
    } else if (i + 1 < words.size() && !words[i + 1].starts_with("--")) {
      option.value = words[++i];
    }
    m_options.push_back(std::move(option));
  }
}

void ScriptLineReader::complain(std::string problem) {
  if (m_problem.empty()) m_problem = std::move(problem);
}

Status ScriptLineReader::status() const {
  const auto malformed = [](std::string problem) {
    return Error{ScriptError::Malformed, {std::move(problem)}, {}, {}};
  };
  if (!m_problem.empty()) return malformed(m_problem);
  if (hasWord()) return malformed(inQuotes(m_words[m_next]) + " is too much");
  for (const Option& option : m_options)
    if (!option.isUsed) return malformed(m_verb + " has no option " + inQuotes("--" + option.name));
  return Done{};
}

std::string ScriptLineReader::word(const char* what) {
  if (hasWord()) return m_words[m_next++];
  complain(std::string(what) + " is missing");
  return {};
}

std::string ScriptLineReader::line(const char* what) {
  m_next = m_words.size();
  m_options.clear();
  m_problem.clear();
  if (m_line.empty()) complain(std::string(what) + " is missing");
  return m_line;
}

ScriptLineReader::Option* ScriptLineReader::find(std::string_view name) {
  for (Option& option : m_options)
    if (option.name == name) return &option;
  return nullptr;
}

// A word after a flag is an operand after all.
OperationValues ScriptLineReader::values(const Operation& operation) {
  OperationValues values(operation);
  for (const Parameter& parameter : operation.parameters) {
    Option* given = find(parameter.id());
    if (!given && !parameter.formerId.empty()) given = find(parameter.formerId);
    if (!given) continue;
    given->isUsed = true;
    if (!given->value && !parameter.isFlag()) complain("--" + given->name + " needs a value");
    complain(readWord(values, parameter, given->value.value_or("")));
  }
  return values;
}

std::uint32_t ScriptLineReader::index(std::string_view word, const char* what, std::size_t count) {
  std::uint32_t index = 0;
  if (!readIndex(word, index)) {
    complain(inQuotes(word) + " is not the number of a " + what);
  } else if (index >= count) {
    complain("there is no " + std::string(what) + " " + std::to_string(index) +
             (count == 0 ? ", nor any" : ", only 0 to " + std::to_string(count - 1)));
  }
  return index;
}

std::vector<std::uint32_t> ScriptLineReader::indices(std::string_view list, const char* what, std::size_t count) {
  std::vector<std::uint32_t> all;
  for (const std::string_view part : parted(list, ',')) {
    all.push_back(index(part, what, count));
    if (!isGood()) return {};
  }
  return all;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> ScriptLineReader::pairs(std::string_view list, const char* what,
                                                                             std::size_t count) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  for (const std::string_view part : parted(list, ',')) {
    const std::size_t colon = part.find(':');
    if (colon == std::string_view::npos) complain(inQuotes(part) + " is not a pair such as 3:7");
    if (!isGood()) return {};
    all.emplace_back(index(part.substr(0, colon), what, count), index(part.substr(colon + 1), what, count));
  }
  return isGood() ? all : std::vector<std::pair<std::uint32_t, std::uint32_t>>();
}

FaceSelection ScriptLineReader::faces(std::string_view ranges, std::size_t slotCount) {
  FaceSelection faces;
  for (const std::string_view part : parted(ranges, ',')) {
    const std::size_t dash = part.find('-');
    const std::uint32_t first = index(part.substr(0, dash), "triangle", slotCount);
    const std::uint32_t last =
        dash == std::string_view::npos ? first : index(part.substr(dash + 1), "triangle", slotCount);
    if (isGood() && last < first) complain(inQuotes(part) + " runs backwards");
    if (!isGood()) return {};
    for (Face f = first; f <= last; ++f) faces.add(f);
  }
  return faces;
}

double ScriptLineReader::number(std::string_view word) {
  double value = 0.0;
  if (!readNumber(word, value)) complain(inQuotes(word) + " is not a number");
  return value;
}

Vec3 ScriptLineReader::point(std::string_view word) {
  const std::vector<std::string_view> parts = parted(word, ',');
  if (parts.size() != 3) complain(inQuotes(word) + " is not X,Y,Z");
  if (!isGood()) return Vec3::Zero();
  return {number(parts[0]), number(parts[1]), number(parts[2])};
}

}  // namespace handwheel
