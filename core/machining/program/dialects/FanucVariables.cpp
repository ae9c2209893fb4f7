// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/dialects/FanucRun.h"

#include <charconv>
#include <cmath>
#include <ctime>

namespace handwheel {

namespace {

constexpr int kMostOffsets = 64;  // entries of the tool memory that variables reach
constexpr double kMostAlarm = 200.0;

ProgramValue known(double number) {
  return {number, false};
}

// Returns true for the numbers that a program may use freely: local and common variables.
bool isFree(int n) {
  return n <= 33 || (n >= 100 && n <= 199) || (n >= 500 && n <= 999);
}

struct Unknown {
  const char *reason, *remedy;
};

constexpr const char* kWriteValue = "Write the value itself, or one of the variables that docs/programs.md lists.";

// Returns the reason why a variable of the control has no value here.
Unknown whyUnknown(int n) {
  if (n < 1000) return {"there is no variable of this number", "Use #1 to #33, #100 to #199 or #500 to #999."};
  if (n < 2000) return {"a signal of the machine is not simulated", "Write the value that the signal has."};
  if (n < 3000) return {"there is no such entry of the tool memory", kWriteValue};
  if (n >= 4000 && n < 4500) return {"this mode of the control is not known here", kWriteValue};
  if (n >= 5061 && n <= 5080) return {"there is no position of a skip (G31)", kWriteValue};
  if (n >= 5101 && n <= 5120) return {"the deviation of the drives is not simulated", kWriteValue};
  if (n >= 5001 && n <= 5340 && (n - 5001) % 20 > 1)
    return {"this lathe has no such axis, only X (1) and Z (2)", "Use the variable of X or Z."};
  return {"this variable of the control is not known here", kWriteValue};
}

[[noreturn]] void refuseUnknown(int n, const SourceLocation& location) {
  const Unknown why = whyUnknown(n);
  refuse(location, "#" + std::to_string(n), why.reason, why.remedy);
}

std::tm localTime(std::time_t at) {
  std::tm parts{};
  localtime_r(&at, &parts);
  return parts;
}

}  // namespace

std::optional<ProgramValue> FanucRun::systemVariable(int n, const SourceLocation& location) const {
  if (isFree(n)) return {};
  for (const auto read :
       {&FanucRun::offsetVariable, &FanucRun::controlVariable, &FanucRun::modalVariable, &FanucRun::positionVariable})
    if (const std::optional<ProgramValue> value = (this->*read)(n)) return value;
  refuseUnknown(n, location);
}

// Returns the length of a radius or of a z in the program's units; X is a diameter.
ProgramValue FanucRun::lengthValue(const ProfilePoint& p, int axis) const {
  return known((axis == 0 ? 2.0 * p.x() : p.y()) / m_machine.unit());
}

// The tool memory with geometry and wear: wear #2001 (X), #2101 (Z), #2201 (R), the direction of the tip #2301,
// geometry #2701 (X), #2801 (Z), #2901 (R). Nothing is worn here. #2501 and #2601 shift the work.
std::optional<ProgramValue> FanucRun::offsetVariable(int n) const {
  if (n == 2501 || n == 2601) return known(0.0);
  if (n < 2001 || n > 2999) return {};
  const int entry = n % 100;
  if (entry < 1 || entry > kMostOffsets) return {};
  const ProgramTool& tool = m_setup.tool(entry);
  switch (n / 100) {
    case 20:
    case 21:
    case 22:
      return known(0.0);
    case 23:
      return known(tool.orientation);
    case 27:
    case 28:
      return lengthValue(tool.offset, n / 100 - 27);
    case 29:
      return known(tool.noseRadius / m_machine.unit());
    default:
      return {};
  }
}

double FanucRun::timer() const {
  return std::floor(1000.0 * m_path.time + m_control.jumps);
}

std::optional<ProgramValue> FanucRun::controlVariable(int n) const {
  switch (n) {
    case 3001:
      return known(timer() - m_control.timerZero);
    case 3002:
      return known(m_path.time / 3600.0 - m_control.hoursZero);
    case 3003:
      return known(m_control.singleBlock);
    case 3004:
      return known(m_control.feedHold);
    case 3007:
      return known(0.0);  // no axis is mirrored
    case 3011: {
      const std::tm now = localTime(m_control.begin);
      return known(1e4 * (1900 + now.tm_year) + 100.0 * (1 + now.tm_mon) + now.tm_mday);
    }
    case 3012: {
      constexpr double kMostTime = 1e9;  // s
      const std::tm now = localTime(m_control.begin + static_cast<std::time_t>(std::min(m_path.time, kMostTime)));
      return known(1e4 * now.tm_hour + 100.0 * now.tm_min + now.tm_sec);
    }
    case 3901:
      return known(m_control.parts);
    case 3902:
      return known(m_control.partsWanted);
    default:
      return {};
  }
}

// The number of the program or macro that runs.
double FanucRun::programNumber() const {
  for (auto frame = m_frames.rbegin(); frame != m_frames.rend(); ++frame) {
    const ProgramOutline::Statement* const head = frame->begin > 0 ? m_outline.statement(frame->begin - 1) : nullptr;
    int number = 0;
    if (head && std::from_chars(head->label.data(), head->label.data() + head->label.size(), number).ec == std::errc())
      return number;
  }
  return m_control.program;
}

// The modes that the blocks before have set: #4001 to #4016 by groups of G codes, #4109 to #4120 by letters.
std::optional<ProgramValue> FanucRun::modalVariable(int n) const {
  const ProgramMachine::Modal& modal = m_machine.modal;
  const int motion = modal.motion / 10;
  const bool isDrilling = motion >= 80 && motion < 90;
  switch (n) {
    case 4001:
      if (modal.motion < 0) return {};
      return known(isDrilling ? 0.0 : motion);
    case 4002:
      return known(modal.isSurfaceSpeed ? 96.0 : 97.0);
    case 4005:
      return known(modal.feedMode == ProgramMachine::FeedMode::PerMinute ? 98.0 : 99.0);
    case 4006:
      return known(modal.isInch ? 20.0 : 21.0);
    case 4007:
      return known(m_control.nose);
    case 4010:
      return known(isDrilling ? motion : 80.0);
    case 4012:
      return known(67.0);  // no modal macro
    case 4014:
      return known(54.0 + m_machine.system());
    case 4015:
      return known(m_control.path);
    case 4016:
      return known(18.0);
    case 4109:
      return known(modal.feed / m_machine.unit());
    case 4113:
      return known(m_control.lastM);
    case 4114:
      return known(m_control.sequence);
    case 4115:
      return known(programNumber());
    case 4119:
      return known(m_control.speed);
    case 4120:
      return known(m_control.tool);
    case 4130:
      return known(0.0);  // no additional coordinate system
    default:
      return {};
  }
}

// The positions of X (1) and Z (2), and the zero points #5201 (external) and #5221 to #5322 (G54 to G59).
std::optional<ProgramValue> FanucRun::positionVariable(int n) const {
  if (n < 5001 || (n - 5001) % 20 > 1) return {};
  const int axis = (n - 5001) % 20, group = (n - 5001) / 20;
  switch (group) {
    case 0:  // end of the block before
    case 2:  // position at present
      return lengthValue(position(), axis);
    case 1:
      return lengthValue(m_machine.toMachine(position()), axis);
    case 10:
      return known(0.0);
    default:
      if (group < 11 || group > 16) return {};
      return lengthValue(m_machine.systemOffset(group - 11), axis);
  }
}

bool FanucRun::setSystemVariable(const ProgramAssignment& set) {
  const auto& [n, value, location, comment] = set;
  if (isFree(n)) return false;
  switch (n) {
    case 3000:
      if (!(value.number >= 0.0 && value.number <= kMostAlarm))
        refuse(location, "#3000", "the number of an alarm is from 0 to 200", "Correct it.");
      alarm(location, std::to_string(3000 + static_cast<int>(value.number)), comment);
    case 3001:
      m_control.timerZero = timer() - value.number;
      return true;
    case 3002:
      m_control.hoursZero = m_path.time / 3600.0 - value.number;
      return true;
    case 3003:
      m_control.singleBlock = value.number;
      return true;
    case 3004:
      m_control.feedHold = value.number;
      return true;
    case 3006:
      note(location, comment.empty() ? "The machine stops here (#3006)." : "The machine stops here: " + comment + ".");
      return true;
    case 3901:
      m_control.parts = value.number;
      return true;
    case 3902:
      m_control.partsWanted = value.number;
      return true;
    default:
      return setZeroPoint(set);
  }
}

// Sets the zero point of G54 to G59. All other variables of the machine can only be read.
bool FanucRun::setZeroPoint(const ProgramAssignment& set) {
  const int axis = (set.number - 5221) % 20, system = (set.number - 5221) / 20;
  if (set.number < 5221 || system > 5 || axis > 1) return false;
  if (m_machine.isCompensated())
    refuse(set.location, "#" + std::to_string(set.number), "the coordinates cannot change with nose compensation",
           "Write G40 before it.");
  if (m_contour)
    refuse(set.location, "#" + std::to_string(set.number),
           std::string("the coordinates cannot change ") +
               (m_cornerWord ? "between a corner and the cut that ends it" : "in the contour of a cycle"),
           "Set it before or after these lines.");
  ProfilePoint offset = m_machine.systemOffset(system);
  if (axis == 0)
    offset.x() = 0.5 * m_machine.unit() * set.value.number;
  else
    offset.y() = m_machine.unit() * set.value.number;
  m_machine.setSystem(system, offset);
  return true;
}

}  // namespace handwheel
