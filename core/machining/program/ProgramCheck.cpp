// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramCheck.h"

#include "base/NumberText.h"
#include "machining/program/ProgramErrors.h"
#include "machining/program/ProgramInterpreter.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace handwheel {

namespace {

constexpr std::size_t kMostRead = std::size_t{16} << 20;  // bytes, limit for all runs together
constexpr std::uint64_t kMostBlocks = 300'000;            // limit for each run after the first

// A line of a text, without its end.
struct LineSpan {
  std::size_t begin = 0, end = 0;
};

LineSpan lineAt(const std::string& text, std::uint64_t line) {
  LineSpan span;
  for (std::uint64_t i = 1; i < line && span.begin < text.size(); ++i)
    span.begin = std::min(text.find('\n', span.begin), text.size() - 1) + 1;
  span.end = std::min(text.find('\n', span.begin), text.size());
  return span;
}

std::size_t columnOf(const Error& error) {
  std::size_t column = 0;
  const std::string& text = error.arguments.front();
  std::from_chars(text.data(), text.data() + text.size(), column);
  return column;
}

// Returns true if the error is about a code. Only the code is left out: the rest of its line may be refused, too.
bool isCode(const Error& error) {
  const char letter = error.arguments[1].empty() ? '\0' : error.arguments[1].front();
  return letter == 'G' || letter == 'M';
}

// Blanks the refused text. Returns false if there is nothing to blank.
bool blank(std::string& text, const Error& error, bool isWholeLine) {
  const LineSpan line = lineAt(text, error.position.value);
  std::size_t from = line.begin, to = line.end;
  const std::size_t column = columnOf(error);
  if (!isWholeLine && column > 0 && line.begin + column <= line.end) {
    from = line.begin + column - 1;
    to = from + 1;
    while (to < line.end && (isDigit(text[to]) || text[to] == '.' || text[to] == ' ')) ++to;
  }
  bool isAny = false;
  for (std::size_t i = from; i < to; ++i) {
    isAny = isAny || (text[i] != ' ' && text[i] != '\r');
    if (text[i] != '\r') text[i] = ' ';
  }
  return isAny;
}

// Indications of a dialect: those of LinuxCNC count up, those of Fanuc down.
class DialectSigns {
 public:
  int of(std::string_view line) {
    m_line = without(line);
    m_sum = 0;
    for (const char* sign : {"O<", "SUB", "ENDSUB", "#<", "G33", "G43", "G95", "G7 ", "G8 ", "G61.1", "G59.1", "G90.1",
                             "G91.1", "G92.1", "G71.1", "G71.2", "M6", "M06", "G10L"})
      count(sign, 1);
    for (const char* sign : {"GOTO", "WHILE[", "IF[", "DO1", "END1", "G65", "G32", "G50S", "M98P", "G0T"})
      count(sign, -1);
    if (!m_line.empty() && m_line.front() == 'O' && m_line.size() > 1 && isDigit(m_line[1]) && isPlainNumber(1))
      --m_sum;
    countTools();
    countIncrements();
    return m_sum;
  }

 private:
  // Returns the line in capitals, without blanks and comments; a blank behind G7 and G8 is kept as the end of the word.
  static std::string without(std::string_view line) {
    std::string kept;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == ';') break;
      if (line[i] == '(') {
        i = std::min(line.find(')', i), line.size() - 1);
        continue;
      }
      if (std::isspace(static_cast<unsigned char>(line[i]))) continue;
      kept += static_cast<char>(std::toupper(static_cast<unsigned char>(line[i])));
    }
    for (const char* word : {"G7", "G8"})
      if (const std::size_t at = kept.find(word);
          at != kept.npos && (at + 2 == kept.size() || !(isDigit(kept[at + 2]) || kept[at + 2] == '.')))
        kept.insert(at + 2, " ");
    return kept;
  }

  void count(std::string_view sign, int weight) {
    const std::size_t at = m_line.find(sign);
    if (at == m_line.npos) return;
    const std::size_t behind = at + sign.size();
    const bool goesOn = isDigit(sign.back()) && behind < m_line.size() && isDigit(m_line[behind]);
    if (!goesOn) m_sum += weight;
  }

  bool isPlainNumber(std::size_t at) const {
    return std::all_of(m_line.begin() + static_cast<std::ptrdiff_t>(at), m_line.end(),
                       [](char c) { return isDigit(c); });
  }

  std::size_t digitsAt(std::size_t at) const {
    std::size_t end = at;
    while (end < m_line.size() && isDigit(m_line[end])) ++end;
    return end - at;
  }

  // T0101 is a tool with its offset.
  void countTools() {
    if (const std::size_t at = m_line.find('T'); at != m_line.npos && digitsAt(at + 1) == 4) m_sum -= 2;
  }

  // U and W of a plain move are increments of Fanuc.
  void countIncrements() {
    if (m_line.find_first_of("[#<") != m_line.npos) return;
    const auto isWord = [this](std::size_t at) {
      return at != m_line.npos && at + 1 < m_line.size() &&
             (isDigit(m_line[at + 1]) || m_line[at + 1] == '-' || m_line[at + 1] == '.');
    };
    if (isWord(m_line.find('U')) || isWord(m_line.find('W'))) --m_sum;
  }

  std::string m_line;
  int m_sum = 0;
};

}  // namespace

std::vector<Error> programProblems(std::string_view text, const ProgramSetup& setup, Progress progress) {
  std::vector<Error> problems;
  std::string left(text);
  ProgramSetup shorter = setup;
  std::size_t read = 0;
  std::uint64_t codeLine = 0;  // line of the code that was left out
  while (problems.size() < kMostProblems && read <= kMostRead && !progress.cancelled()) {
    read += text.size();
    const Result<ToolPath> path = runProgram(left, shorter, progress);
    if (path) break;
    const Error& error = path.error();
    const bool isRefused = error.code == ProgramError::Refused && error.arguments.size() >= 2;
    const std::uint64_t line = error.position.value;
    // The words of a code that was left out belong to it; further codes of the line do not.
    const bool isFollowing = isRefused && line == codeLine && !isCode(error);
    if (problems.empty() || (isRefused && !isFollowing)) problems.push_back(error);
    if (!isRefused || !blank(left, error, isFollowing || !isCode(error))) break;
    codeLine = isCode(error) ? line : 0;
    shorter.mostBlocks = std::min(shorter.mostBlocks, kMostBlocks);
  }
  return problems;
}

std::optional<ProgramDialect> recognisedDialect(std::string_view text) {
  DialectSigns signs;
  int sum = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    sum += signs.of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (sum == 0) return std::nullopt;
  return sum > 0 ? ProgramDialect::LinuxCnc : ProgramDialect::Fanuc;
}

}  // namespace handwheel
