// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/dialects/FanucRun.h"

#include <charconv>
#include <cmath>

namespace handwheel {

namespace {

// The variables of the words of G65, by letter from A; 0: no argument.
constexpr int kArgumentOf[26] = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
constexpr int kMostArgument = 33;

}  // namespace

void FanucRun::readLine(std::uint32_t i, ProgramScanner& scanner) {
  if (const ProgramOutline::Statement* const statement = m_outline.statement(i)) {
    if (statement->keyword != ProgramOutline::Keyword::Program) {
      runLoop(*statement, i);
      return;
    }
    beginProgram(*statement, {i + 1, 1});
    return;
  }
  m_hasProgram = true;
  if (runMacro(i, scanner)) return;
  ProgramBlock block = readBlock(scanner, m_variables, m_setup);
  if (block.sequence && !m_contour) m_control.sequence = *block.sequence;
  if (block.words.empty()) return;
  if (m_setup.hasIncrements) scaleIncrements(block);
  begin(block);
  m_contour ? collect(block) : execute(block);
}

// The O number of a program, which is the end of the one before it in the file.
void FanucRun::beginProgram(const ProgramOutline::Statement& head, const SourceLocation& location) {
  if (!m_frames.empty()) refuseMissingReturn(location);
  if (m_hasProgram) m_isDone = true;
  if (!m_isDone) std::from_chars(head.label.data(), head.label.data() + head.label.size(), m_control.program);
  m_hasProgram = true;
}

void FanucRun::runLoop(const ProgramOutline::Statement& statement, std::uint32_t i) {
  if (statement.keyword == ProgramOutline::Keyword::FanucEnd) {
    ++m_control.jumps;
    m_next = statement.head;
    return;
  }
  ProgramScanner scanner(m_outline.line(i), i + 1);
  while (scanner.takeSkip(true)) {
  }
  if (scanner.takeIf('N')) scanner.number();
  if (skipsRest(scanner, m_setup)) return;
  if (!scanner.takeIf(std::string_view("WHILE"))) return;  // DO without a condition
  if (valueIn(scanner).number == 0.0) m_next = statement.end + 1;
}

void FanucRun::goTo(std::uint32_t i, ProgramScanner& scanner) {
  const SourceLocation location = scanner.location();
  const double n = std::round(valueIn(scanner).number);
  const std::uint32_t line = n >= 1.0 && n <= 1e8 ? m_outline.numbered(static_cast<int>(n), i) : kNone;
  if (line == kNone) refuse(location, "GOTO", "there is no line with this number", "Correct the number after GOTO.");
  if (line <= i) ++m_control.jumps;
  m_next = line;
}

// Runs IF and GOTO. Returns false for a line of words.
bool FanucRun::runMacro(std::uint32_t i, ProgramScanner& scanner) {
  const std::size_t start = scanner.at();
  if (scanner.takeIf('N') && scanner.nextIsNumber()) scanner.number();
  if (skipsRest(scanner, m_setup)) return true;
  if (scanner.takeIf(std::string_view("GOTO"))) {
    goTo(i, scanner);
    return true;
  }
  if (!scanner.takeIf(std::string_view("IF"))) {
    scanner.seek(start);
    return false;
  }
  const bool isTrue = valueIn(scanner).number != 0.0;
  if (scanner.takeIf(std::string_view("GOTO"))) {
    if (isTrue) goTo(i, scanner);
    return true;
  }
  if (!scanner.takeIf(std::string_view("THEN")))
    refuse(scanner.location(), scanner.token(), "GOTO or THEN is expected after the condition",
           "Write IF [...] GOTO n.");
  if (isTrue && !readBlock(scanner, m_variables, m_setup).words.empty())
    refuse(scanner.location(), "THEN", "only a variable can be set after THEN", "Use GOTO for more.");
  return true;
}

// Runs G65 P L with arguments.
void FanucRun::callMacro(const ProgramBlock& block, const ProgramWord& g) {
  const int p = whole({'P', needed('P', g, "the number of the macro"), true, g.location}, 1, 9999);
  const std::uint32_t sub = m_outline.subprogram(std::to_string(p));
  if (sub == kNone)
    refuse(g.location, "P" + std::to_string(p), "there is no macro with this number", "Put it into the same file.");
  std::vector<ProgramValue> arguments(kMostArgument, ProgramValue{0.0, true});
  int repeats = 1;
  for (const ProgramWord& w : block.words) {
    if (&w == &g || w.letter == 'P') continue;
    if (w.letter == 'L') {
      repeats = whole(w, 1, 9999);
      word('L');
      continue;
    }
    const int number = w.letter >= 'A' && w.letter <= 'Z' ? kArgumentOf[w.letter - 'A'] : 0;
    if (number == 0) refuse(w.location, w.text(), "this letter is no argument of a macro", "Use another letter.");
    arguments[static_cast<std::size_t>(number) - 1] = {w.number, false};
    word(w.letter);
  }
  call(sub + 1, arguments, repeats, true, g.location);
}

}  // namespace handwheel
