// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramOutline.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

using Keyword = ProgramOutline::Keyword;

struct Name {
  const char* text;
  Keyword keyword;
};

// Longer words come before their prefixes.
constexpr Name kKeywords[] = {{"SUB", Keyword::Sub},
                              {"ENDSUB", Keyword::EndSub},
                              {"CALL", Keyword::Call},
                              {"RETURN", Keyword::Return},
                              {"ELSEIF", Keyword::ElseIf},
                              {"ELSE", Keyword::Else},
                              {"ENDIF", Keyword::EndIf},
                              {"IF", Keyword::If},
                              {"ENDWHILE", Keyword::EndWhile},
                              {"WHILE", Keyword::While},
                              {"ENDREPEAT", Keyword::EndRepeat},
                              {"REPEAT", Keyword::Repeat},
                              {"DO", Keyword::Do},
                              {"BREAK", Keyword::Break},
                              {"CONTINUE", Keyword::Continue}};

// Returns true if a condition, a count or arguments follow the keyword.
bool takesValue(Keyword keyword) {
  switch (keyword) {
    case Keyword::Call:
    case Keyword::Return:
    case Keyword::EndSub:
    case Keyword::If:
    case Keyword::ElseIf:
    case Keyword::While:
    case Keyword::Repeat:
      return true;
    default:
      return false;
  }
}

SourceLocation locationOf(std::uint32_t line) {
  return {line + 1, 1};
}

// Returns true if there is another line that begins with %.
bool hasMarkedEnd(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first < end && text[first] == '%') return true;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

[[noreturn]] void refuseUnclosed(std::uint32_t line, const std::string& label) {
  refuse(locationOf(line), "O" + label, "its other half is missing",
         "Every sub, if, while, do and repeat needs its end with the same label.");
}

}  // namespace

ProgramOutline::ProgramOutline(std::string_view text, ProgramDialect dialect) {
  if (text.size() > kMostBytes)
    throw ProgramRefusal{
        {ErrorCode::FileTooLarge, {"bytes", std::to_string(text.size()), std::to_string(kMostBytes)}, {}, {}}};
  split(text, dialect);
  for (std::uint32_t i = 0; i < size(); ++i) readLine(i, dialect);
  link();
}

// Splits the text into lines. A line that begins with % begins or ends the tape; text after the second is not read. A
// title may precede the first, as on the leader of a tape; words there are refused, since a machine would not run them.
// If a file has only one, it ends the tape if words precede it.
void ProgramOutline::split(std::string_view text, ProgramDialect dialect) {
  bool hasWords = false, hasMark = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (m_lines.size() >= kMostLines)
      throw ProgramRefusal{{ErrorCode::FileTooLarge, {"lines", "", std::to_string(kMostLines)}, {}, {}}};
    if (line.size() > kLongestLine)
      refuse(locationOf(size()), "", "the line has more than 4096 bytes", "Is this a program? Divide the line.");
    const std::size_t first = line.find_first_not_of(" \t\r");
    const bool isMark = first != std::string_view::npos && line[first] == '%';
    m_lines.push_back(isMark ? std::string_view() : line);
    if (!isMark) {
      hasWords = hasWords || ProgramScanner(line, size()).hasWords();
    } else if (hasMark) {
      return;
    } else if (!hasWords) {
      hasMark = true;
    } else {
      if (dialect == ProgramDialect::Fanuc && hasMarkedEnd(text))
        refuse(locationOf(size() - 1), "%", "the program begins here, but words precede it",
               "Remove the words before the first %, or the %.");
      return;
    }
  }
}

ProgramOutline::Statement& ProgramOutline::add(std::uint32_t i, Keyword keyword, std::string label, std::size_t rest) {
  return m_statements.insert_or_assign(i, Statement{keyword, std::move(label), rest}).first->second;
}

void ProgramOutline::readLine(std::uint32_t i, ProgramDialect dialect) {
  const std::size_t first = m_lines[i].find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return;
  static constexpr std::string_view kBegins = "/nNoO:wWdDeE(";  // the first characters of lines of the outline
  if (kBegins.find(m_lines[i][first]) == std::string_view::npos) return;
  ProgramScanner scanner(m_lines[i], i + 1);
  while (scanner.takeSkip(dialect == ProgramDialect::Fanuc)) {
  }
  if (scanner.peek() == 'N') {
    scanner.take();
    if (!scanner.nextIsNumber()) return;  // read, and possibly refused, when it is executed
    const double n = scanner.number();
    if (n >= 0.0 && n <= 1e8 && n == std::floor(n)) m_numbered[static_cast<int>(n)].push_back(i);
  }
  if (dialect == ProgramDialect::Fanuc)
    while (scanner.takeSkip(true)) {
    }
  if (scanner.peek() == 'O' || (scanner.peek() == ':' && dialect == ProgramDialect::Fanuc))
    readO(scanner, i, dialect);
  else if (dialect == ProgramDialect::Fanuc)
    readFanucLoop(scanner, i);
}

void ProgramOutline::readO(ProgramScanner& scanner, std::uint32_t i, ProgramDialect dialect) {
  const SourceLocation location = scanner.location();
  scanner.take();
  std::string label;
  if (scanner.peek() == '<') {
    label = scanner.name();
  } else if (scanner.nextIsNumber()) {
    label = roundedText(scanner.number(), 12);
  } else {
    refuse(location, "O" + scanner.token(), "the label of an O word is a number or a <name>",
           "Write the number itself; labels that are computed are not supported.");
  }
  if (dialect == ProgramDialect::LinuxCnc) {
    for (const Name& name : kKeywords) {
      if (!scanner.takeIf(std::string_view(name.text))) continue;
      add(i, name.keyword, label, scanner.at());
      if (name.keyword == Keyword::Sub) m_subs.emplace(label, i);
      if (!takesValue(name.keyword)) scanner.expectEnd();
      return;
    }
    if (scanner.peek() != '\0')
      refuse(scanner.location(), scanner.token(), "this is no keyword of an O word",
             "Use sub, endsub, call, return, if, elseif, else, endif, while, endwhile, do, repeat, endrepeat, break or "
             "continue.");
  }
  if (dialect == ProgramDialect::Fanuc) {
    scanner.expectEnd();
    m_programs.push_back(i);
  }
  add(i, Keyword::Program, label, scanner.at());
  m_subs.emplace(label, i);
}

// Reads WHILE [...] DO1 and END1, behind a slash and a number of the line.
void ProgramOutline::readFanucLoop(ProgramScanner& scanner, std::uint32_t i) {
  const std::string text = scanner.rest();
  if (text.starts_with("END") && text.size() == 4) {
    add(i, Keyword::FanucEnd, "do" + text.substr(3), 0);
  } else if (text.starts_with("WHILE") || text.starts_with("DO")) {
    const std::size_t at = text.rfind("DO");
    if (at != std::string::npos && at + 3 == text.size()) add(i, Keyword::FanucWhile, "do" + text.substr(at + 2), 0);
  }
}

const ProgramOutline::Statement* ProgramOutline::statement(std::uint32_t i) const {
  const auto found = m_statements.find(i);
  return found == m_statements.end() ? nullptr : &found->second;
}

std::uint32_t ProgramOutline::subprogram(const std::string& label) const {
  const auto found = m_subs.find(label);
  return found == m_subs.end() ? kNone : found->second;
}

std::uint32_t ProgramOutline::numbered(int n, std::uint32_t from) const {
  const auto found = m_numbered.find(n);
  if (found == m_numbered.end()) return kNone;
  const auto next = std::upper_bound(m_programs.begin(), m_programs.end(), from);
  const std::uint32_t begin = next == m_programs.begin() ? 0 : *(next - 1);
  const std::uint32_t end = next == m_programs.end() ? size() : *next;
  const std::vector<std::uint32_t>& lines = found->second;
  auto line = std::lower_bound(lines.begin(), lines.end(), from);
  if (line == lines.end() || *line >= end) line = std::lower_bound(lines.begin(), lines.end(), begin);
  return line == lines.end() || *line >= end ? kNone : *line;
}

// The line i ends the statement that was opened last with its label, or continues it.
void ProgramOutline::close(std::uint32_t i, Statement& statement) {
  std::vector<std::uint32_t>& open = m_open[statement.label];
  if (open.empty()) refuseUnclosed(i, statement.label);
  Statement& before = m_statements.at(open.back());
  const auto begins = [&](Keyword a, Keyword b) { return before.keyword == a || before.keyword == b; };
  const auto require = [&](bool isRight) {
    if (!isRight) refuseUnclosed(i, statement.label);
  };
  statement.head = before.head == kNone ? open.back() : before.head;
  switch (statement.keyword) {
    case Keyword::ElseIf:
    case Keyword::Else:
    case Keyword::EndIf:
      require(begins(Keyword::If, Keyword::ElseIf) ||
              (before.keyword == Keyword::Else && statement.keyword == Keyword::EndIf));
      before.next = i;
      break;
    case Keyword::EndSub:
      require(begins(Keyword::Sub, Keyword::Sub));
      break;
    case Keyword::EndWhile:
      require(begins(Keyword::While, Keyword::While));
      break;
    case Keyword::EndRepeat:
      require(begins(Keyword::Repeat, Keyword::Repeat));
      break;
    case Keyword::DoWhile:
      require(begins(Keyword::Do, Keyword::Do));
      break;
    default:
      require(begins(Keyword::FanucWhile, Keyword::FanucWhile));
      break;
  }
  open.pop_back();
  if (statement.keyword == Keyword::ElseIf || statement.keyword == Keyword::Else) {
    open.push_back(i);
    return;
  }
  // Stores the end in all branches.
  for (std::uint32_t line = statement.head; line != kNone && line != i;) {
    Statement& branch = m_statements.at(line);
    branch.end = i;
    line = branch.next;
  }
}

void ProgramOutline::link() {
  for (auto& [i, statement] : m_statements) {
    switch (statement.keyword) {
      case Keyword::Sub:
      case Keyword::If:
      case Keyword::Do:
      case Keyword::Repeat:
      case Keyword::FanucWhile:
        m_open[statement.label].push_back(i);
        break;
      case Keyword::While: {
        const std::vector<std::uint32_t>& open = m_open[statement.label];
        if (!open.empty() && m_statements.at(open.back()).keyword == Keyword::Do) {
          statement.keyword = Keyword::DoWhile;
          close(i, statement);
        } else {
          m_open[statement.label].push_back(i);
        }
        break;
      }
      case Keyword::Break:
      case Keyword::Continue:
        if (m_open[statement.label].empty()) refuseUnclosed(i, statement.label);
        statement.head = m_open[statement.label].back();
        break;
      case Keyword::Call:
      case Keyword::Return:
      case Keyword::Program:
        break;
      default:
        close(i, statement);
        break;
    }
  }
  for (const auto& [label, lines] : m_open)
    if (!lines.empty()) refuseUnclosed(lines.back(), label);
  m_open.clear();
}

}  // namespace handwheel
