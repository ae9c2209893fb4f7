// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/RapidTables.h"

#include "robot/posts/RapidNames.h"

#include <algorithm>
#include <array>

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

RapidTables::RapidTables(const RobotProgram& program, std::vector<RapidScope> scopes) : m_program(program) {
  m_declarations.setScopes(std::move(scopes));
  m_tools.add(named("tool0"), Pose(Pose::Identity()));
  m_frames.add(named("wobj0"), Pose(Pose::Identity()));
  if (!program.frameName.empty() && !program.declaresFrame) m_frames.add(named(rapidFrameName(program)), program.frame);
  addKnownFrames();
}

bool RapidTables::isData(std::string_view name) const {
  const RapidName known = named(name);
  return m_jointTargets.contains(known) || m_robTargets.contains(known) || m_speeds.contains(known) ||
         m_tools.contains(known) || m_frames.contains(known) || m_zones.contains(known);
}

void RapidTables::addKnownFrames() {
  RobotProgram program;
  for (const ProgramFrame& frame : m_program.knownFrames) {
    program.frameName = frame.name;
    program.otherFrames = m_program.otherFrames;
    std::erase(program.otherFrames, frame.name);
    for (const std::string& name : rapidFrameNames(program)) {
      if (!m_frames.contains(named(name))) m_frames.add(named(name), frame.pose);
    }
  }
}

Status RapidTables::readData(const RapidData& data) {
  const ProgramStatement& statement = data.statement;
  LineReader line(statement.text, statement.line);
  if (callsRapidRoutine(line.rest()) && !data.words.empty()) return unread(line.rest(), statement.line);
  constexpr std::array kTypes = {"jointtarget", "robtarget", "speeddata", "zonedata", "tooldata", "wobjdata"};
  const auto type = std::ranges::find_if(kTypes, [&](const char* word) { return line.takeWord(word); });
  const bool isRecord = data.words.ends_with("RECORD "), isTable = !isRecord && type != kTypes.end();
  const RapidName name = m_declarations.add(data, !isRecord && !isTable);
  if (data.words.empty() || isRecord) return Done{};
  if (!isTable) {
    if (!data.words.ends_with("CONST ") || !line.takeWord("num")) return Done{};
    line.name();
    m_numbers.add(name, line.take(":=") ? numberAlone(line.rest()) : std::nullopt);
    return Done{};
  }
  line.name();
  const bool hasValue = line.take(":=");
  const std::string_view word = *type;
  if (word == "zonedata") {
    m_zones.add(name, hasValue ? zoneFrom(line) : std::nullopt);
  } else if (word == "tooldata") {
    m_tools.add(name, hasValue ? toolFrom(line) : std::nullopt);
  } else if (word == "wobjdata") {
    m_frames.add(name, hasValue ? frameFrom(line) : std::nullopt);
  } else {
    const bool isTarget = word != "speeddata";
    if (isTarget && (name.second.empty() || !hasValue)) return line.malformed("target", "a name and := were expected");
    const auto numbers = hasValue ? line.numbersWithin('[', ']', 20) : std::nullopt;
    const bool isUsable = numbers && !numbers->empty();
    if (isTarget && !isUsable) return line.malformed("target", "numbers in brackets were expected");
    (word == "jointtarget" ? m_jointTargets
     : isTarget            ? m_robTargets
                           : m_speeds)
        .add(name, isUsable ? numbers : std::nullopt);
  }
  return Done{};
}

std::optional<double> RapidTables::numberIn(std::string_view text) const {
  if (const auto number = numberAlone(text)) return number;
  LineReader line(text, 0);
  const double sign = line.take("-") ? -1.0 : 1.0;
  const auto known = m_numbers.find(named(line.name()));
  line.skipSpace();
  return known && line.rest().empty() ? std::optional(sign * *known) : std::nullopt;
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

std::optional<Pose> RapidTables::toolFrom(LineReader& line) {
  const bool isHeld = line.take("[") && line.takeWord("TRUE") && line.take(",");
  const auto numbers = isHeld ? line.numbersWithin('[', ']', 7) : std::nullopt;
  return numbers && numbers->size() == 7 ? poseFrom(*numbers) : std::nullopt;
}

std::optional<Pose> RapidTables::frameFrom(LineReader& line) {
  const bool stands = line.take("[") && line.takeWord("FALSE") && line.take(",") && line.takeWord("TRUE") &&
                      line.take(",") && line.take("\"\"") && line.take(",");
  const auto user = stands ? line.numbersWithin('[', ']', 7) : std::nullopt;
  const auto object = user && line.take(",") ? line.numbersWithin('[', ']', 7) : std::nullopt;
  if (!object || user->size() != 7 || object->size() != 7) return std::nullopt;
  const std::optional<Pose> first = poseFrom(*user), second = poseFrom(*object);
  return first && second ? std::optional<Pose>(*first * *second) : std::nullopt;
}

std::optional<Pose> RapidTables::frameIn(std::string_view text) const {
  LineReader line(text, 0);
  line.name();
  const bool isNamed = line.take("\\WObj") && line.take(":=");
  return m_frames.find(named(isNamed ? line.name() : std::string_view("wobj0")));
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
    zone = m_zones.contains(named(name)) ? m_zones.find(named(name)) : standardZone(name);
  }
  if (line.take("\\Z") && line.take(":=")) zone = line.number();
  line.skipSpace();
  if (!zone || !(*zone >= 0.0) || !line.rest().empty()) return unread(text, number);
  return *zone;
}

}  // namespace handwheel
