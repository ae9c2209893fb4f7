// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/NumberText.h"
#include "robot/posts/ControllerConfiguration.h"
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/ExternalAxes.h"
#include "robot/posts/FanucConfiguration.h"
#include "robot/posts/FanucFrames.h"
#include "robot/posts/KeptLines.h"
#include "robot/posts/PostErrors.h"
#include "robot/posts/PostText.h"
#include "robot/posts/ProgramRoutines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace handwheel {

namespace {

// The positions of a /POS section, by their numbers: their components, by name.
using FanucPosition = std::map<std::string, double, std::less<>>;

// Reads "UF : 0, J1 = 1.5 deg, X = 2 mm": each name with its number. Others are skipped.
// turning: receives the names of angles.
void readAssignments(std::string_view text, FanucPosition& position, std::set<std::string, std::less<>>& turning) {
  for (std::size_t at = text.find_first_of("=:"); at != text.npos; at = text.find_first_of("=:", at + 1)) {
    std::size_t end = at;
    while (end > 0 && text[end - 1] == ' ') --end;
    std::size_t begin = end;
    while (begin > 0 && text[begin - 1] != ' ' && text[begin - 1] != ',' && text[begin - 1] != '\t') --begin;
    LineReader value(text.substr(at + 1), 0);
    const auto number = value.number();
    if (!number || end - begin > 2) continue;
    const std::string name(text.substr(begin, end - begin));
    position[name] = *number;
    if (value.takeWord("deg")) turning.insert(name);
  }
}

std::optional<std::vector<double>> valuesOf(const FanucPosition& position, std::initializer_list<const char*> names) {
  std::vector<double> values;
  for (const char* const name : names) {
    const auto found = position.find(name);
    if (found == position.end()) return std::nullopt;
    values.push_back(found->second);
  }
  return values;
}

// Reads the number of "P[12]", or with a remark "P[12:home]". 0: none.
std::size_t positionNumber(LineReader& line) {
  if (!line.take("P[")) return 0;
  const auto number = line.number();
  if (!number || !(*number >= 1.0 && *number <= static_cast<double>(PostProcessor::kMostMotions))) return 0;
  line.skip(line.rest().find(']') + 1);
  return static_cast<std::size_t>(*number);
}

// Returns the remark of "P[12:home]"; empty: none.
std::string_view positionRemark(std::string_view position) {
  const std::size_t begin = position.find(':'), end = position.find(']');
  return begin < end && end != position.npos ? position.substr(begin + 1, end - begin - 1) : std::string_view();
}

// Parses the speed after the target: "50%", "100mm/sec", "60cm/min", "4inch/min", or the duration in "2sec",
// "500msec", which becomes `seconds`. None: another unit.
std::optional<double> fanucSpeedFrom(LineReader line, bool isJoint, double& seconds) {
  const auto value = line.number();
  if (!value || !(*value > 0.0)) return std::nullopt;
  const bool isInSeconds = line.takeWord("sec");
  if (isInSeconds || line.takeWord("msec")) {
    seconds = isInSeconds ? *value : 1e-3 * *value;
    return std::nullopt;
  }
  if (isJoint) return line.take("%") ? std::optional(std::min(1.0, 0.01 * *value)) : std::nullopt;
  if (line.take("mm/sec")) return *value;
  if (line.take("cm/min")) return *value * 10.0 / 60.0;
  if (line.take("inch/min")) return *value * 25.4 / 60.0;
  return std::nullopt;
}

// Beginnings of statements that neither move the robot nor change the effect of others. Anything that is in no list is
// refused.
constexpr std::array kFanucStill = {"WAIT", "F[", "R[", "TIMER", "OVERRIDE", "MESSAGE", "COL ", "$WAITTMOUT"};
// Statements of this kind by which a tool may grip or release.
constexpr std::array kFanucGripping = {"DO[", "RO[", "GO[", "AO[", "PAYLOAD"};

bool beginsWithOneOf(const LineReader& line, std::span<const char* const> beginnings) {
  return std::ranges::any_of(beginnings, [&](const char* beginning) { return LineReader(line).take(beginning); });
}

class FanucReading {
 public:
  explicit FanucReading(const RobotProgram& program)
      : m_program(program), m_closed(closedFormOfSphericalWrist(program.arm)) {}

  Status read(const ProgramStatement& statement) {
    LineReader line(statement.text, statement.line);
    if (line.take("/")) {
      m_isInLines = line.takeWord("MN");
      m_isInPositions = !m_isInLines && line.takeWord("POS");
      return Done{};
    }
    if (m_isInPositions) readPosition(line);
    m_isInOwnHead = m_isInOwnHead || (!m_isInLines && statement.text.find(kOwnFanucComment) != std::string_view::npos);
    return m_isInLines ? readLine(statement) : Status(Done{});
  }

  // Returns the motions with their positions.
  Result<std::vector<ParsedMotion>> motions() {
    std::optional<double> tool;
    ArmValues reference = ArmValues::Zero(m_program.arm.size());  // joint values, as far as the program defines them
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
      const std::size_t number = m_numbers[i];
      ParsedMotion& motion = m_kept.motions()[i];
      const FanucPosition& position = m_positions[number];
      constexpr std::array kNames{"UF", "UT"};
      for (std::size_t k = 0; k < kNames.size(); ++k) {
        const auto given = position.find(kNames[k]);
        if (m_selections[i][k] && given != position.end() && given->second != *m_selections[i][k])
          return LineReader({}, motion.line).malformed("target", "its frame or tool is not the selected one");
      }
      if (m_twice.contains(number)) return LineReader({}, motion.line).malformed("target", "it is in /POS twice");
      if (!takeExternal(number, position, motion.line))
        return LineReader({}, motion.line).malformed("target", ExternalAxes::kMoved);
      if (const auto joints = valuesOf(position, {"J1", "J2", "J3", "J4", "J5", "J6"});
          joints && m_program.arm.size() == 6) {
        motion.joints = countedByModel(coupled(m_program.arm), radiansOf(*joints));
        if (const auto set = m_frames.find(frameNumber(position)); set != m_frames.end()) setFrame(*set, motion);
      } else if (const auto pose = valuesOf(position, {"X", "Y", "Z", "R", "P", "W"})) {
        // User frames except the world are on the controller, unless the program sets them.
        const double inFrame = frameNumber(position);
        const auto set = m_frames.find(inFrame);
        if (m_program.arm.size() != 6 || (inFrame != 0.0 && set == m_frames.end()))
          return LineReader({}, motion.line).refused(PostError::DataElsewhere);
        if (inFrame != 0.0) setFrame(*set, motion);
        // The data of tools are on the controller: 0 is the flange, the other one the tool of the cell.
        const auto named = valuesOf(position, {"UT"});
        const double used = named ? named->front() : 1.0;
        if (used != 0.0 && used != tool.value_or(used))
          return LineReader({}, motion.line).malformed("target", "it is of another tool than those before");
        if (used != 0.0) tool = used;
        Pose inWorld(Eigen::Translation3d((*pose)[0], (*pose)[1], (*pose)[2]));
        inWorld.linear() = fromZyx(Vec3((*pose)[3], (*pose)[4], (*pose)[5]) * kRadiansPerDegree);
        if (used == 0.0) motion.tool = Pose::Identity();
        motion.pose = poseInProgram(m_program, motion.frame.value_or(fanucWorld(m_program.arm)), inWorld,
                                    used == 0.0 ? Pose(Pose::Identity()) : m_program.tool);
        if (motion.kind == ProgramMotion::Kind::Joint && !takeConfiguration(number, reference, motion))
          return LineReader({}, motion.line).refused(PostError::PoseUnreached);
      } else {
        return LineReader({}, motion.line).malformed("target", "its place is not in /POS, or not all of it");
      }
      if (motion.joints) reference = *motion.joints;
    }
    addExternal();
    return m_kept.take();
  }

 private:
  // Takes the external axes of the robot's group, and the other groups. Returns false if one of these moves.
  bool takeExternal(std::size_t number, const FanucPosition& position, std::size_t line) {
    AxisValues axes;
    for (const auto& [name, value] : position) {
      if (name.size() == 2 && name[0] == 'E') axes[name] = value;
    }
    const std::string& groups = m_groups[number];
    if (number == m_numbers.front()) m_groupsOfAll = groups;
    return m_external.take(axes, line) && (groups.empty() || groups == m_groupsOfAll);
  }

  // Adds the line "E1= 1000 mm, E2= 5 deg GP2: UF : 0, …" of what the positions have beside the robot.
  void addExternal() {
    std::string text;
    for (const auto& [name, value] : m_external.values()) {
      if (m_external.isAnySet())
        text += (text.empty() ? "" : ", ") + name + "= " + shortestText(value) +
                (m_turning.contains(name) ? " deg" : " mm");
    }
    text += (text.empty() ? "" : " ") + m_groupsOfAll;
    if (!m_groupsOfAll.empty() || m_external.isAnySet())
      m_kept.before().push_back(keptLine(ProgramLine::Kind::Axes, text, m_kept.motions().front().line));
  }

  // Sets the joint values of a joint motion to a pose from its CONFIG, if it has one. A line keeps the configuration in
  // which it begins. Returns false if no solution of the robot has the CONFIG.
  bool takeConfiguration(std::size_t position, const ArmValues& reference, ParsedMotion& motion) const {
    const auto wanted = m_configurations.find(position);
    if (wanted == m_configurations.end() || !m_closed) {
      motion.isConfigurationOpen = true;
      return true;
    }
    const Pose tip = m_program.frame * *motion.pose * m_program.tool.inverse(Eigen::Isometry);
    motion.joints = jointsWith(wanted->second, m_program.arm, *m_closed, tip, reference);
    motion.isAtPose = motion.joints.has_value();
    if (motion.joints) motion.pose = std::nullopt;
    return motion.joints.has_value();
  }

  void setFrame(const std::pair<const double, Pose>& frame, ParsedMotion& motion) const {
    const auto named = m_frameNames.find(frame.first);
    motion.frame = frame.second;
    motion.frameName = named != m_frameNames.end() ? named->second : "UFRAME_" + fixedText(frame.first, 0);
  }

  // Reads "!Sets UFRAME[9], PR[9] to", and in the next line "!NAME".
  void readRemark(LineReader line, std::size_t number) {
    const std::string_view remark = line.rest();
    if (m_named) {
      line.take("!");
      if (const std::string_view name = line.name(); !name.empty()) m_frameNames[*m_named] = readName(name);
      m_named.reset();
    } else if (line.take(kSetsFanucFrame)) {
      m_named = line.number();
    } else if (!m_isInOwnHead) {
      m_kept.keep(ProgramLine::Kind::Comment, remark.substr(remark.starts_with("//") ? 2 : 1), number);
    }
  }

  void readPosition(LineReader& line) {
    if (const std::size_t number = positionNumber(line)) {
      m_open = number;
      if (!m_once.insert(number).second) m_twice.insert(number);
      m_isOwnGroup = true;
    }
    // Only the first of several motion groups is the robot.
    for (std::size_t at = 0; (at = line.rest().find(kFanucGroup, at)) != std::string_view::npos;) {
      const std::string_view text = line.rest();
      LineReader group(text.substr(at + kFanucGroup.size()), 0);
      const auto number = group.number();
      if (!number || !group.take(":")) {  // "GP" within a remark
        ++at;
        continue;
      }
      takePosition(text.substr(0, at));
      line.skip(text.size() - group.rest().size());
      m_isOwnGroup = *number == 1.0;
      if (!m_isOwnGroup) takePosition(std::string(kFanucGroup) + fixedText(*number, 0) + ":");
      at = 0;
    }
    takePosition(line.rest());
  }

  void takePosition(std::string_view text) {
    if (m_open == 0) return;
    if (!m_isOwnGroup) {
      std::string& groups = m_groups[m_open];
      for (const char c : text) {
        const bool isSpace = c == ' ' || c == '\t';
        if (c != '}' && !(isSpace && (groups.empty() || groups.ends_with(' ')))) groups += isSpace ? ' ' : c;
      }
      if (!groups.empty() && !groups.ends_with(' ')) groups += ' ';
      return;
    }
    readAssignments(text, m_positions[m_open], m_turning);
    if (const auto configuration = fanucConfigurationFrom(text)) m_configurations[m_open] = *configuration;
  }

  Status readLine(const ProgramStatement& statement) {
    LineReader line(statement.text, statement.line);
    line.number();  // number of the line
    line.take(":");
    line.skipSpace();
    if (line.rest().empty()) return Done{};
    if (line.rest()[0] == '!' || line.rest().starts_with("//")) {
      readRemark(line, statement.line);
      return Done{};
    }
    m_named.reset();
    if (LineReader(line).take("UTOOL_NUM")) m_isInOwnHead = false;
    // Each position has the numbers of its frame and tool, which must be the selected ones.
    for (auto& [name, selected] : m_selected) {
      LineReader chosen = line;
      if (!chosen.take(name)) continue;
      selected = chosen.take("=") ? chosen.number() : std::nullopt;
      return Done{};
    }
    // A time-out jumps elsewhere: "WAIT DI[1]=ON TIMEOUT,LBL[2]".
    if (LineReader(line).take("WAIT") && lowerCase(std::string(line.rest())).find("timeout") != std::string::npos)
      return unread(line.rest(), statement.line);
    const bool mayGrip = beginsWithOneOf(line, kFanucGripping);
    if (mayGrip || beginsWithOneOf(line, kFanucStill)) {
      m_kept.keep(ProgramLine::Kind::Statement, line.rest(), statement.line, mayGrip);
      return Done{};
    }
    const std::string_view whole = line.rest();
    if (LineReader(line).take("PR[") || LineReader(line).take("UFRAME["))
      return readsFrame(line) ? Status(Done{}) : unread(whole, statement.line);
    const bool isJoint = line.takeWord("J"), isLinear = !isJoint && line.takeWord("L");
    if (!isJoint && !isLinear) return unread(whole, statement.line);
    const std::string_view position = line.rest();
    const std::size_t number = positionNumber(line);
    if (number == 0) return line.malformed("target", "P[number] was expected");
    if (m_kept.isFull()) return line.malformed("J", "there are too many motions");
    ParsedMotion motion{
        isJoint ? ProgramMotion::Kind::Joint : ProgramMotion::Kind::Linear, {}, {}, 0.0, statement.line};
    motion.name = readName(positionRemark(position));
    motion.speed = fanucSpeedFrom(line, isJoint, motion.seconds);
    if (const Status options = readOptions(line, statement.line, motion); !options) return options.error();
    if (!motion.speed && !(motion.seconds > 0.0)) m_kept.leaveOut(statement.line);
    m_numbers.push_back(number);
    m_selections.push_back({m_selected[0].second, m_selected[1].second});
    m_kept.add(std::move(motion));
    return Done{};
  }

  // Returns the number of the frame of a position; below 0: not given.
  static double frameNumber(const FanucPosition& position) {
    const auto found = position.find("UF");
    return found == position.end() ? -1.0 : found->second;
  }

  // Reads "PR[9]=LPOS-LPOS", "PR[9,1]=(-12.5)", "UFRAME[9]=PR[9]" before all motions. Returns false for other
  // statements.
  bool readsFrame(LineReader line) {
    if (!m_numbers.empty() || m_program.arm.size() != 6) return false;
    const bool isFrame = line.take("UFRAME[");
    if (!isFrame) line.take("PR[");
    const auto number = line.number();
    const auto element = !isFrame && line.take(",") ? line.number() : std::nullopt;
    if (!number || !line.take("]") || !line.take("=")) return false;
    const auto isOver = [&] {
      line.skipSpace();
      return line.rest().empty();
    };
    if (isFrame) {
      const auto from = line.take("PR[") ? line.number() : std::nullopt;
      const auto values = from ? m_registers.find(*from) : m_registers.end();
      if (*number < 1.0 || values == m_registers.end() || !line.take("]") || !isOver()) return false;
      const auto& [x, y, z, w, p, r] = values->second;
      Pose pose(Eigen::Translation3d(x, y, z));
      pose.linear() = fromZyx(Vec3(r, p, w) * kRadiansPerDegree);
      m_frames[*number] = fanucWorld(m_program.arm) * pose;
      return true;
    }
    if (!element) {
      if (!line.take("LPOS-LPOS") || !isOver()) return false;
      m_registers[*number] = {};
      return true;
    }
    const auto values = m_registers.find(*number);
    const bool isInBrackets = line.take("(");
    const auto value = line.number();
    const bool isWhole = value && (!isInBrackets || line.take(")")) && isOver();
    if (!isWhole || values == m_registers.end()) return false;
    for (std::size_t i = 0; i < values->second.size(); ++i) {
      if (*element != static_cast<double>(i + 1)) continue;
      values->second[i] = *value;
      return true;
    }
    return false;
  }

  // Reads the words after the speed: "FINE", "CNT50", "ACC80", "PTH"; others, as Offset, Tool_Offset or INC, change the
  // position, or, as Wjnt in lines, the configurations on the way.
  Status readOptions(LineReader line, std::size_t number, ParsedMotion& motion) {
    line.number();
    line.skip(std::min(line.rest().find_first_of(" \t"), line.rest().size()));  // unit of the speed
    for (line.skipSpace(); !line.rest().empty(); line.skipSpace()) {
      const bool isJoint = motion.kind == ProgramMotion::Kind::Joint;
      if (line.takeWord("FINE")) continue;
      if ((isJoint && line.takeWord("Wjnt")) || line.takeWord("PTH")) {
        m_kept.leaveOut(number);
        continue;
      }
      LineReader valued = line;
      const bool isCorner = valued.take("CNT");
      const auto value = isCorner || valued.take("ACC") ? valued.number() : std::nullopt;
      if (!value || (isCorner && !(*value >= 0.0 && *value <= ProgramMotion::kLargestCorner)))
        return unread(line.rest(), number);
      if (isCorner)
        motion.corner = *value;
      else
        m_kept.leaveOut(number);
      line = valued;
    }
    return Done{};
  }

  const RobotProgram& m_program;
  std::map<double, std::array<double, 6>> m_registers;  // X, Y, Z, W, P, R in mm and degrees, by their numbers
  std::map<double, std::string> m_frameNames;
  std::optional<double> m_named;    // frame whose name is in the next remark
  std::map<double, Pose> m_frames;  // user frames in the base, by their numbers
  std::map<std::size_t, FanucPosition> m_positions;
  std::map<std::size_t, FanucConfiguration> m_configurations;  // by numbers of positions
  std::optional<ClosedFormIk> m_closed;
  std::vector<std::size_t> m_numbers;  // numbers of the positions of the motions
  // The selected frame and tool at this time and of each motion; none: unknown. A controller stops where a position has
  // others.
  std::array<std::pair<const char*, std::optional<double>>, 2> m_selected{{{"UFRAME_NUM", {}}, {"UTOOL_NUM", {}}}};
  std::vector<std::array<std::optional<double>, 2>> m_selections;
  KeptLines m_kept;
  ExternalAxes m_external;
  std::set<std::string, std::less<>> m_turning;  // names of components that are angles
  std::map<std::size_t, std::string> m_groups;   // other motion groups, by numbers of positions
  std::string m_groupsOfAll;                     // those of all positions
  std::set<std::size_t> m_once, m_twice;         // numbers of positions
  std::size_t m_open = 0;
  bool m_isInLines = true, m_isInPositions = false, m_isOwnGroup = true, m_isInOwnHead = false;
};

}  // namespace

Result<std::vector<ParsedMotion>> FanucPost::read(std::string_view text, const RobotProgram& frame) const {
  const Result<std::string> plain = programText(text);
  if (!plain) return plain.error();
  const Result<std::vector<std::string_view>> lines =
      programLines(*plain, {});  // "!" begins remarks at the begin of lines only
  if (!lines) return lines.error();
  FanucReading reading(frame);
  for (const ProgramStatement& each : statementsOf(*lines)) {
    if (const Status read = reading.read(each); !read) return read.error();
  }
  return reading.motions();
}

}  // namespace handwheel
