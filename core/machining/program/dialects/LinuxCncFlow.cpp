// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/dialects/LinuxCncRun.h"

#include "base/NumberText.h"

#include <cctype>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kMostArguments = 30;
constexpr int kMostRepeats = 1'000'000'000;

}  // namespace

void LinuxCncRun::readLine(std::uint32_t i, ProgramScanner& scanner) {
  if (const ProgramOutline::Statement* const statement = m_outline.statement(i)) {
    runStatement(i, *statement);
    return;
  }
  const ProgramBlock block = readBlock(scanner, m_variables, m_setup);
  if (block.words.empty()) return;
  begin(block);
  m_contour ? collect(block) : execute(block);
}

// Ends the program if the last comment of the line is (ABORT, message).
void LinuxCncRun::obeyComment(std::uint32_t i, const ProgramScanner& scanner) {
  constexpr std::string_view kAbort = "ABORT,";
  const std::string comment = scanner.lastComment();
  if (comment.empty()) return;
  std::string word;
  std::size_t at = 0;
  for (; at < comment.size() && word.size() < kAbort.size(); ++at)
    if (comment[at] != ' ' && comment[at] != '\t')
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(comment[at])));
  if (word == kAbort)
    alarm({i + 1, 1}, "ABORT", comment.substr(std::min(comment.find_first_not_of(' ', at), comment.size())));
}

double LinuxCncRun::condition(std::uint32_t i, const ProgramOutline::Statement& statement) {
  ProgramScanner scanner(m_outline.line(i), i + 1);
  scanner.seek(statement.rest);
  const double value = valueIn(scanner).number;
  scanner.expectEnd();
  return value;
}

void LinuxCncRun::runStatement(std::uint32_t i, const ProgramOutline::Statement& statement) {
  ProgramScanner scanner(m_outline.line(i), i + 1);
  scanner.seek(statement.rest);
  const SourceLocation location{i + 1, 1};
  switch (statement.keyword) {
    case Keyword::Sub:
      m_next = statement.end + 1;
      return;
    case Keyword::Program:
      // The definition of a subprogram with M99 at its end.
      if (!m_frames.empty() && m_frames.back().begin == i + 1) return;
      m_isDone = true;
      if (m_path.moves.empty())  // true for a program for another control
        note(location,
             "O" + statement.label +
                 " begins a subprogram, before which the program ends without a move. Choose the dialect fanuc "
                 "if it is meant to begin here.");
      return;
    case Keyword::Call:
      beginCall(statement, scanner, location);
      return;
    case Keyword::EndSub:
    case Keyword::Return:
      takeReturned(scanner);
      if (m_frames.empty())
        refuse(location, "O" + statement.label, "there is nothing to return from", "Call the subprogram instead.");
      returnFromCall();
      return;
    case Keyword::If:
    case Keyword::ElseIf:
    case Keyword::Else:
    case Keyword::EndIf:
      runBranch(i, statement);
      return;
    default:
      runLoop(i, statement);
      return;
  }
}

// Reads the value behind return or endsub.
void LinuxCncRun::takeReturned(ProgramScanner& scanner) {
  m_returned = scanner.peek() == '\0' ? 0.0 : valueIn(scanner).number;
  scanner.expectEnd();
}

void LinuxCncRun::beginCall(const ProgramOutline::Statement& statement, ProgramScanner& scanner,
                            const SourceLocation& location) {
  const std::uint32_t sub = m_outline.subprogram(statement.label);
  if (sub == kNone)
    refuse(location, "O" + statement.label, "there is no subprogram with this name", "Put it into the same file.");
  std::vector<ProgramValue> arguments;
  while (scanner.peek() == '[') {
    if (arguments.size() >= kMostArguments)
      refuse(scanner.location(), "[", "a call has at most 30 arguments",
             "Use variables that begin with an underscore.");
    arguments.push_back(valueIn(scanner));
  }
  if (scanner.peek() != '\0')
    refuse(scanner.location(), scanner.token(), "the arguments of a call must be in square brackets", "Write [value].");
  call(sub + 1, arguments, 1, true, location);
}

void LinuxCncRun::runBranch(std::uint32_t i, const ProgramOutline::Statement& statement) {
  if (statement.keyword == Keyword::EndIf) return;
  if (statement.keyword != Keyword::If) {  // the branch before it has run
    m_next = statement.end + 1;
    return;
  }
  const ProgramOutline::Statement* branch = &statement;
  for (std::uint32_t line = i;;) {
    if (branch->keyword == Keyword::EndIf || branch->keyword == Keyword::Else || condition(line, *branch) != 0.0) {
      m_next = line + 1;
      return;
    }
    line = branch->next;
    branch = m_outline.statement(line);
  }
}

void LinuxCncRun::runLoop(std::uint32_t i, const ProgramOutline::Statement& statement) {
  if (m_frames.empty()) m_frames.emplace_back().returnTo = m_outline.size();  // frame of the program itself
  std::map<std::uint32_t, int>& loops = m_frames.back().loops;
  switch (statement.keyword) {
    case Keyword::While:
      if (condition(i, statement) == 0.0) m_next = statement.end + 1;
      return;
    case Keyword::EndWhile:
      m_next = statement.head;
      return;
    case Keyword::DoWhile:
      if (condition(i, statement) != 0.0) m_next = statement.head + 1;
      return;
    case Keyword::Repeat: {
      const double count = std::round(condition(i, statement));
      loops[i] = static_cast<int>(std::clamp(count, 0.0, static_cast<double>(kMostRepeats)));
      if (loops[i] == 0) m_next = statement.end + 1;
      return;
    }
    case Keyword::EndRepeat:
      if (--loops[statement.head] > 0) m_next = statement.head + 1;
      return;
    case Keyword::Break:
    case Keyword::Continue:
      leaveLoop(i, statement, statement.keyword == Keyword::Continue);
      return;
    default:
      return;  // do
  }
}

void LinuxCncRun::leaveLoop(std::uint32_t i, const ProgramOutline::Statement& statement, bool isAgain) {
  const ProgramOutline::Statement& loop = *m_outline.statement(statement.head);
  if (loop.keyword == Keyword::If || loop.end == kNone)
    refuse({i + 1, 1}, "O" + statement.label, "there is no loop around it with this label",
           "Give it the label of its loop.");
  m_next = isAgain ? loop.end : loop.end + 1;
}

std::optional<ProgramValue> LinuxCncRun::systemVariable(int n, const SourceLocation&) const {
  const double unit = m_machine.unit();
  const ProgramTool& tool = m_setup.tool(m_machine.modal.tool);
  const auto length = [unit](double mm) { return ProgramValue{mm / unit, false}; };
  const auto pair = [&](const ProfilePoint& p, int axis) -> std::optional<ProgramValue> {
    if (axis == 0) return length(p.x());
    return length(axis == 2 ? p.y() : 0.0);
  };
  if (n >= 5161 && n <= 5169) return pair(m_machine.home[0], n - 5161);
  if (n >= 5181 && n <= 5189) return pair(m_machine.home[1], n - 5181);
  if (n >= 5211 && n <= 5219) return pair(m_savedShift, n - 5211);  // also while G92.2 suspends it
  if (n == 5220) return ProgramValue{m_machine.system() + 1.0, false};
  if (n >= 5221 && n <= 5390) {
    const int system = (n - 5221) / 20;
    if (system < ProgramMachine::kSystems) return pair(m_machine.systemOffset(system), (n - 5221) % 20);
  }
  if (n >= 5420 && n <= 5428) return pair(position(), n - 5420);
  if (n == 5400) return ProgramValue{static_cast<double>(m_machine.modal.tool), false};
  if (n >= 5401 && n <= 5409) return pair(m_machine.toolOffset(), n - 5401);
  if (n == 5410) return length(2.0 * tool.noseRadius);
  if (n == 5413) return ProgramValue{static_cast<double>(tool.orientation), false};
  return {};
}

std::optional<double> LinuxCncRun::systemVariable(const std::string& name) const {
  const ProgramMachine::Modal& modal = m_machine.modal;
  using FeedMode = ProgramMachine::FeedMode;
  const auto flag = [](bool is) { return is ? 1.0 : 0.0; };
  const std::pair<const char*, double> values[] = {
      {"_x", position().x() / m_machine.unit()},
      {"_z", position().y() / m_machine.unit()},
      {"_y", 0.0},
      {"_vmajor", 2.9},
      {"_vminor", 0.0},
      {"_line", m_next},
      {"_call_level", static_cast<double>(m_frames.size())},
      {"_motion_mode", modal.motion < 0 ? 800.0 : modal.motion},
      {"_plane", modal.isDrillPlane ? 170.0 : 180.0},
      {"_metric", flag(!modal.isInch)},
      {"_imperial", flag(modal.isInch)},
      {"_absolute", flag(!modal.isIncremental)},
      {"_incremental", flag(modal.isIncremental)},
      {"_inverse_time", flag(modal.feedMode == FeedMode::InverseTime)},
      {"_units_per_minute", flag(modal.feedMode == FeedMode::PerMinute)},
      {"_units_per_rev", flag(modal.feedMode == FeedMode::PerRevolution)},
      {"_coord_system", 540.0 + 10.0 * m_machine.system()},
      {"_spindle_rpm_mode", flag(!modal.isSurfaceSpeed)},
      {"_spindle_css_mode", flag(modal.isSurfaceSpeed)},
      {"_ijk_absolute_mode", flag(modal.isArcAbsolute)},
      {"_lathe_diameter_mode", flag(modal.isDiameter)},
      {"_lathe_radius_mode", flag(!modal.isDiameter)},
      {"_spindle_on", flag(modal.spin != 0)},
      {"_spindle_cw", flag(modal.spin > 0)},
      {"_mist", flag(modal.hasMist)},
      {"_flood", flag(modal.hasFlood)},
      {"_feed", modal.feedMode == FeedMode::InverseTime ? modal.feed : modal.feed / m_machine.unit()},
      {"_rpm", modal.spindle},
      {"_current_tool", modal.tool},
      {"_selected_tool", modal.selectedTool},
      {"_task", 0.0},
      {"_value", m_returned},
  };
  for (const auto& [text, value] : values)
    if (name == text) return value;
  return {};
}

}  // namespace handwheel
