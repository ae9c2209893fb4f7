// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/RapidTables.h"

#include "robot/posts/RapidNames.h"

namespace handwheel {

namespace {

// Functions without side effects, and operators before brackets. Others may be routines that move the robot.
constexpr const char* kRapidFunctions[] = {
    "abs",      "acos",    "and",       "asin",     "atan",     "atan2",    "calcjointt", "calcrobt", "clkread",
    "cos",      "crobt",   "cjointt",   "cpos",     "ctool",    "cwobj",    "dim",        "distance", "div",
    "dotprod",  "doutput", "dnumtonum", "eulerzyx", "exp",      "gettime",  "goutput",    "max",      "min",
    "mod",      "not",     "numtodnum", "numtostr", "offs",     "or",       "orientzyx",  "poseinv",  "posemult",
    "posevect", "pow",     "present",   "reltool",  "round",    "sin",      "sqrt",       "strfind",  "strlen",
    "strpart",  "tan",     "testdi",    "trunc",    "valtostr", "vectmagn", "xor"};

// Returns the size of a zone of every controller, mm; none: there is no such zone.
std::optional<double> standardZone(const std::string& name) {
  if (name == "fine") return 0.0;
  if (name == "z0") return 0.3;
  for (const int size : {1, 5, 10, 15, 20, 30, 40, 50, 60, 80, 100, 150, 200}) {
    if (name == "z" + std::to_string(size)) return size;
  }
  return std::nullopt;
}

}  // namespace

bool callsRapidRoutine(std::string_view text) {
  return callsOther(text, kRapidFunctions);
}

RapidTables::RapidTables(const RobotProgram& program) : m_program(program) {
  m_tools["tool0"] = m_frames["wobj0"] = Pose::Identity();
  if (!program.frameName.empty() && !program.declaresFrame) m_frames[folded(rapidFrameName(program))] = program.frame;
  addKnownFrames();
}

bool RapidTables::isData(const std::string& name) const {
  return m_jointTargets.contains(name) || m_robTargets.contains(name) || m_speeds.contains(name) ||
         m_tools.contains(name) || m_frames.contains(name) || m_zones.contains(name);
}

void RapidTables::addKnownFrames() {
  RobotProgram named;
  for (const ProgramFrame& frame : m_program.knownFrames) {
    named.frameName = frame.name;
    named.otherFrames = m_program.otherFrames;
    std::erase(named.otherFrames, frame.name);
    for (const std::string& name : rapidFrameNames(named)) m_frames.emplace(folded(name), frame.pose);
  }
}

Status RapidTables::readData(const RapidData& data) {
  const ProgramStatement& statement = data.statement;
  LineReader line(statement.text, statement.line);
  if (callsRapidRoutine(line.rest())) return unread(line.rest(), statement.line);
  if (line.takeWord("zonedata")) return readZone(line);
  if (line.takeWord("tooldata")) return readTool(line);
  if (line.takeWord("wobjdata")) return readFrame(line);
  Table* const table = line.takeWord("jointtarget") ? &m_jointTargets
                       : line.takeWord("robtarget") ? &m_robTargets
                       : line.takeWord("speeddata") ? &m_speeds
                                                    : nullptr;
  if (!table) {
    if (data.storage == "CONST") readNumber(line);
    const std::string words = (data.isLocal ? "LOCAL " : "") + std::string(data.storage) + " ";
    m_before.push_back(keptLine(ProgramLine::Kind::Declaration, words + std::string(statement.text), statement.line));
    return Done{};
  }
  const std::string name = folded(line.name());
  const bool isTarget = table != &m_speeds;
  if (name.empty() || !line.take(":="))
    return isTarget ? Status(line.malformed("target", "a name and := were expected")) : Done{};
  const auto numbers = line.numbersWithin('[', ']', 20);
  if (numbers && !numbers->empty())
    (*table)[name] = *numbers;
  else if (isTarget)
    return line.malformed("target", "numbers in brackets were expected");
  return Done{};
}

void RapidTables::readNumber(LineReader line) {
  if (!line.takeWord("num")) return;
  const std::string name = folded(line.name());
  const auto number = line.take(":=") ? numberAlone(line.rest()) : std::nullopt;
  const auto [known, isNew] = m_numbers.emplace(name, number);
  if (!isNew && known->second != number) known->second = std::nullopt;
}

std::optional<double> RapidTables::numberIn(std::string_view text) const {
  if (const auto number = numberAlone(text)) return number;
  LineReader line(text, 0);
  const double sign = line.take("-") ? -1.0 : 1.0;
  const auto known = m_numbers.find(folded(line.name()));
  line.skipSpace();
  if (!line.rest().empty() || known == m_numbers.end() || !known->second) return std::nullopt;
  return sign * *known->second;
}

std::optional<double> RapidTables::zoneFrom(LineReader& line) {
  if (!line.take("[")) return std::nullopt;
  const bool isStop = line.takeWord("TRUE");
  if ((!isStop && !line.takeWord("FALSE")) || !line.take(",")) return std::nullopt;
  const auto size = line.number();
  if (!size || !line.take(",")) return std::nullopt;
  line.skip(line.rest().find(']') + 1);
  return isStop ? 0.0 : *size;
}

Status RapidTables::readZone(LineReader& line) {
  const std::string name = folded(line.name());
  const auto zone = line.take(":=") ? zoneFrom(line) : std::nullopt;
  const auto [known, isNew] = m_zones.emplace(name, zone);
  if (!isNew && known->second != zone) known->second = std::nullopt;
  return Done{};
}

Status RapidTables::readTool(LineReader& line) {
  const std::string name = folded(line.name());
  if (!line.take(":=")) return Done{};
  const bool isHeld = line.take("[") && line.takeWord("TRUE") && line.take(",");
  const auto numbers = isHeld ? line.numbersWithin('[', ']', 7) : std::nullopt;
  m_tools[name] = numbers && numbers->size() == 7 ? poseFrom(*numbers) : std::nullopt;
  return Done{};
}

Status RapidTables::readFrame(LineReader& line) {
  const std::string name = folded(line.name());
  if (!line.take(":=")) return Done{};
  const bool stands = line.take("[") && line.takeWord("FALSE") && line.take(",") && line.takeWord("TRUE") &&
                      line.take(",") && line.take("\"\"") && line.take(",");
  const auto user = stands ? line.numbersWithin('[', ']', 7) : std::nullopt;
  const auto object = user && line.take(",") ? line.numbersWithin('[', ']', 7) : std::nullopt;
  std::optional<Pose> first, second;
  if (object && user->size() == 7 && object->size() == 7) {
    first = poseFrom(*user);
    second = poseFrom(*object);
  }
  m_frames[name] = first && second ? std::optional<Pose>(*first * *second) : std::nullopt;
  return Done{};
}

std::optional<Pose> RapidTables::frameIn(std::string_view text) const {
  LineReader line(text, 0);
  line.name();
  const bool isNamed = line.take("\\WObj") && line.take(":=");
  const auto frame = m_frames.find(isNamed ? folded(line.name()) : "wobj0");
  return frame == m_frames.end() ? std::nullopt : frame->second;
}

std::string RapidTables::frameNameIn(std::string_view text) {
  LineReader line(text, 0);
  line.name();
  const bool isNamed = line.take("\\WObj") && line.take(":=");
  const std::string_view name = isNamed ? line.name() : std::string_view();
  return folded(name) == "wobj0" ? std::string() : readName(name);
}

std::optional<Pose> RapidTables::poseFrom(const Numbers& n) {
  Eigen::Quaterniond turn(n[3], n[4], n[5], n[6]);
  if (!(turn.norm() > 1e-3) || !(turn.norm() < 1e3)) return std::nullopt;
  Pose pose(Eigen::Translation3d(n[0], n[1], n[2]));
  pose.linear() = turn.normalized().toRotationMatrix();
  return pose;
}

Result<double> RapidTables::blendFrom(std::string_view text, std::size_t number) const {
  LineReader line(text, number);
  auto zone = zoneFrom(line);
  if (!zone) {
    const std::string name = folded(line.name());
    const auto own = m_zones.find(name);
    zone = own != m_zones.end() ? own->second : standardZone(name);
  }
  if (line.take("\\Z") && line.take(":=")) zone = line.number();
  line.skipSpace();
  if (!zone || !(*zone >= 0.0) || !line.rest().empty()) return unread(text, number);
  return *zone;
}

}  // namespace handwheel
