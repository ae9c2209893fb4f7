// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ControllerConfiguration.h"
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/PostText.h"
#include "robot/posts/RapidConfiguration.h"
#include "robot/posts/RapidNames.h"
#include "robot/posts/RapidStatements.h"

#include <algorithm>
#include <array>
#include <map>

namespace handwheel {

namespace {

// Instructions that neither move the robot nor change the effect of others. Anything that is in no list is refused.
constexpr std::array kRapidStill = {"AccSet",   "SingArea", "GripLoad",  "TPWrite", "TPErase", "SetDO",
                                    "SetGO",    "SetAO",    "PulseDO",   "Set",     "Reset",   "InvertDO",
                                    "WaitTime", "WaitDI",   "WaitUntil", "WaitRob", "Stop",    "ClkReset",
                                    "ClkStart", "ClkStop",  "Incr",      "Decr"};

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

class RapidReading {
 public:
  explicit RapidReading(const RobotProgram& program)
      : m_program(program),
        m_joints(static_cast<std::size_t>(program.arm.size())),
        m_closed(closedFormOfSphericalWrist(program.arm)),
        m_reference(ArmValues::Zero(program.arm.size())) {
    m_tools["tool0"] = m_frames["wobj0"] = Pose::Identity();
    if (!program.frameName.empty() && !program.declaresFrame) m_frames[folded(rapidFrameName(program))] = program.frame;
    addKnownFrames();
  }

  Status readData(const ProgramStatement& statement) {
    LineReader line(statement.text, statement.line);
    if (callsOther(line.rest(), kRapidFunctions)) return unread(line.rest(), statement.line);
    if (line.takeWord("zonedata")) return readZone(line);
    if (line.takeWord("tooldata")) return readTool(line);
    if (line.takeWord("wobjdata")) return readFrame(line);
    Table* const table = line.takeWord("jointtarget") ? &m_jointTargets
                         : line.takeWord("robtarget") ? &m_robTargets
                         : line.takeWord("speeddata") ? &m_speeds
                                                      : nullptr;
    if (!table) return Done{};
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

  Status read(const ProgramStatement& statement) {
    LineReader line(statement.text, statement.line);
    if (line.takeWord("MoveAbsJ")) return readMotion(line, statement.line, ProgramMotion::Kind::Joint, true);
    if (line.takeWord("MoveJ")) return readMotion(line, statement.line, ProgramMotion::Kind::Joint, false);
    if (line.takeWord("MoveL")) return readMotion(line, statement.line, ProgramMotion::Kind::Linear, false);
    LineReader other = line;
    other.name();
    if (callsOther(other.rest(), kRapidFunctions)) return unread(statement.text, statement.line);
    if (line.takeWord("VelSet")) {
      readOverride(line);
      return Done{};
    }
    if (line.takeWord("ConfJ")) {
      m_isConfigurationGiven = !line.take("\\") || !line.takeWord("Off");
      return Done{};
    }
    if (line.takeWord("ConfL")) {
      m_isLineConfigurationGiven = !line.take("\\") || !line.takeWord("Off");
      return Done{};
    }
    for (const char* const still : kRapidStill) {
      if (line.takeWord(still)) return Done{};
    }
    const std::string_view word = line.name();
    const std::string name = folded(word);
    const bool isKnown = m_jointTargets.contains(name) || m_robTargets.contains(name) || m_speeds.contains(name) ||
                         m_tools.contains(name) || m_frames.contains(name) || m_zones.contains(name);
    if (!word.empty() && !isKnown && isAssignment(line)) return Done{};
    return unread(statement.text, statement.line);
  }
  std::vector<ParsedMotion> motions;

 private:
  using Numbers = std::vector<double>;
  using Table = std::map<std::string, Numbers>;  // by names in lower case

  // Adds the frames of the cell, under the names in modules of its paths. Those of the file take precedence.
  void addKnownFrames() {
    RobotProgram named;
    for (const ProgramFrame& frame : m_program.knownFrames) {
      named.frameName = frame.name;
      named.otherFrames = m_program.otherFrames;
      std::erase(named.otherFrames, frame.name);
      for (const std::string& name : rapidFrameNames(named)) m_frames.emplace(folded(name), frame.pose);
    }
  }

  // Recognises "n:=1", "p.trans.x:=1", "a{2}:=1", after the name. Words between belong to another statement: IF a THEN
  // n:=1.
  static bool isAssignment(LineReader line) {
    while (true) {
      if (line.take("{"))
        line.skip(line.rest().find('}') + 1);
      else if (line.take("."))
        line.name();
      else
        return line.take(":=");
    }
  }

  // Reads a zone: [FALSE,10,…] in mm, [TRUE,…], which is an exact stop, as 0; none: it is not understood.
  static std::optional<double> zoneFrom(LineReader& line) {
    if (!line.take("[")) return std::nullopt;
    const bool isStop = line.takeWord("TRUE");
    if ((!isStop && !line.takeWord("FALSE")) || !line.take(",")) return std::nullopt;
    const auto size = line.number();
    if (!size || !line.take(",")) return std::nullopt;
    line.skip(line.rest().find(']') + 1);
    return isStop ? 0.0 : *size;
  }

  // Reads a zone. Routines may have different zones of one name: then the zone is not known.
  Status readZone(LineReader& line) {
    const std::string name = folded(line.name());
    const auto zone = line.take(":=") ? zoneFrom(line) : std::nullopt;
    const auto [known, isNew] = m_zones.emplace(name, zone);
    if (!isNew && known->second != zone) known->second = std::nullopt;
    return Done{};
  }

  // Reads the pose of a tool [TRUE,[pose],[load]] in the flange; none, if the robot does not hold it.
  Status readTool(LineReader& line) {
    const std::string name = folded(line.name());
    if (!line.take(":=")) return Done{};
    const bool isHeld = line.take("[") && line.takeWord("TRUE") && line.take(",");
    const auto numbers = isHeld ? line.numbersWithin('[', ']', 7) : std::nullopt;
    m_tools[name] = numbers && numbers->size() == 7 ? poseFrom(*numbers) : std::nullopt;
    return Done{};
  }

  // Reads the pose of a frame [FALSE,TRUE,"",[pose],[pose]] in the base; none, if it moves.
  Status readFrame(LineReader& line) {
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

  // Reads VelSet: percent, largest speed of the tool's centre point. If these are no numbers no speed is known.
  void readOverride(LineReader& line) {
    const auto percent = line.number();
    const auto most = line.take(",") ? line.number() : std::nullopt;
    m_share = percent && most ? 0.01 * *percent : 0.0;
    m_most = most.value_or(0.0);
  }

  // Reads "[[…],…]", a name, or CalcRobT(joints,tool): the numbers, and true if they are joint values.
  Result<std::pair<Numbers, bool>> target(LineReader& line, bool isJoints) {
    if (!isJoints && line.takeWord("CalcRobT")) {
      if (!line.take("(")) return line.malformed("target", "( was expected");
      auto within = target(line, true);
      const std::string_view rest = line.rest();
      std::size_t end = 0;
      for (int depth = 1; depth > 0 && end < line.rest().size(); ++end)
        depth += line.rest()[end] == '(' ? 1 : line.rest()[end] == ')' ? -1 : 0;
      line.skip(end);
      m_calculatedWith = toolText(argumentsOf(rest.substr(0, end > 0 ? end - 1 : 0)), 1);
      return within;
    }
    if (auto numbers = line.numbersWithin('[', ']', 20)) return std::pair(std::move(*numbers), isJoints);
    const Table& known = isJoints ? m_jointTargets : m_robTargets;
    const std::string_view called = line.name();
    const auto found = known.find(folded(called));
    // The prefix that the post writes.
    constexpr std::string_view kTargetPrefix = "p_";
    m_targetName = readName(called.substr(called.starts_with(kTargetPrefix) ? kTargetPrefix.size() : 0));
    if (line.take("(")) return line.malformed("target", "functions as Offs are not read");
    if (found == known.end()) return line.malformed("target", "it is neither numbers nor a name given before");
    return std::pair(found->second, isJoints);
  }

  Status readMotion(LineReader& line, std::size_t number, ProgramMotion::Kind kind, bool wantsJoints) {
    if (motions.size() >= PostProcessor::kMostMotions) return line.malformed("MoveAbsJ", "there are too many motions");
    while (line.take("\\")) {  // such as \Conc
      line.name();
      line.take(",");
    }
    m_calculatedWith.reset();
    m_targetName.clear();
    const auto read = target(line, wantsJoints);
    if (!read) return read.error();
    const auto& [numbers, isJoints] = *read;
    ParsedMotion motion{kind, {}, {}, 0.0, number};
    motion.name = m_targetName;
    if (numbers.size() < (isJoints ? m_joints : 7)) return line.malformed("target", "it has too few numbers");
    if (isJoints)
      motion.joints = radiansOf(std::span(numbers).first(m_joints));
    else if (auto pose = poseFrom(numbers))
      motion.pose = *pose;
    else
      return line.malformed("target", "its quaternion has no direction");
    if (callsOther(line.rest(), kRapidFunctions)) return unread(line.rest(), number);
    const std::vector<std::string_view> arguments = argumentsOf(line.rest());
    if (arguments.size() > 1) setSpeed(arguments[1], motion);
    if (arguments.size() > 2) {
      const Result<double> blend = blendFrom(arguments[2], number);
      if (!blend) return blend.error();
      motion.blend = *blend;
    }
    if (m_calculatedWith && *m_calculatedWith != toolText(arguments, 3))
      return line.malformed("target", "CalcRobT has another tool or frame than the motion");
    const std::string_view tool = arguments.size() > 3 ? arguments[3] : "";
    motion.frame = frameIn(tool);
    motion.frameName = frameNameIn(tool);
    if (const auto known = m_tools.find(folded(LineReader(tool, 0).name())); known != m_tools.end())
      motion.tool = known->second;
    if (motion.pose) {
      const auto pose = placed(*motion.pose, tool, number);
      if (!pose) return pose.error();
      motion.pose = *pose;
      if (!takeConfiguration(numbers, motion))
        return line.malformed("target", "the robot reaches its place in no way with this configuration");
    }
    if (motion.joints) m_reference = *motion.joints;
    motions.push_back(std::move(motion));
    return Done{};
  }

  // Returns the configuration of a robtarget, if its numbers define one.
  std::optional<RapidConfiguration> configurationOf(const Numbers& robtarget) const {
    constexpr std::size_t kBegin = 7, kCount = 4;
    if (!m_closed || robtarget.size() < kBegin + kCount) return std::nullopt;
    return rapidConfigurationFrom(std::span(robtarget).subspan(kBegin, kCount));
  }

  // Sets the joint values of a joint motion to a robtarget from its confdata, if they are given and used. A line keeps
  // the configuration in which it begins, and must end in that of its confdata. Returns false if no solution of the
  // robot has it.
  bool takeConfiguration(const Numbers& robtarget, ParsedMotion& motion) const {
    const auto wanted = configurationOf(robtarget);
    if (motion.kind == ProgramMotion::Kind::Linear) {
      if (m_isLineConfigurationGiven) motion.endsIn = wanted;
      return true;
    }
    if (!wanted || !m_isConfigurationGiven) {
      motion.isConfigurationOpen = true;
      return true;
    }
    const Pose tip = m_program.frame * *motion.pose * m_program.tool.inverse(Eigen::Isometry);
    motion.joints = jointsWith(*wanted, m_program.arm, *m_closed, tip, m_reference);
    if (!motion.joints) return false;
    motion.pose = std::nullopt;
    return true;
  }

  // Returns the argument that names tool and frame, in a normal form.
  static std::string toolText(const std::vector<std::string_view>& arguments, std::size_t at) {
    std::string text = at < arguments.size() ? folded(arguments[at]) : std::string();
    std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
    constexpr std::string_view kStandard = "\\wobj:=wobj0";
    if (text.ends_with(kStandard)) text.resize(text.size() - kStandard.size());
    return text;
  }

  // Returns the frame of "tool" or "tool\WObj:=frame"; none: it is not known.
  std::optional<Pose> frameIn(std::string_view text) const {
    LineReader line(text, 0);
    line.name();
    const bool isNamed = line.take("\\WObj") && line.take(":=");
    const auto frame = m_frames.find(isNamed ? folded(line.name()) : "wobj0");
    return frame == m_frames.end() ? std::nullopt : frame->second;
  }

  // Returns the name of the frame in the text; empty: the base.
  static std::string frameNameIn(std::string_view text) {
    LineReader line(text, 0);
    line.name();
    const bool isNamed = line.take("\\WObj") && line.take(":=");
    const std::string_view name = isNamed ? line.name() : std::string_view();
    return folded(name) == "wobj0" ? std::string() : readName(name);
  }

  // Transforms the pose of a motion with "tool" or "tool\WObj:=frame".
  Result<Pose> placed(const Pose& pose, std::string_view text, std::size_t number) const {
    LineReader line(text, number);
    const auto tool = m_tools.find(folded(line.name()));
    const std::optional<Pose> frame = frameIn(text);
    if (line.take("\\WObj") && line.take(":=")) line.name();
    line.skipSpace();
    if (!line.rest().empty()) return unread(line.rest(), number);
    if (tool == m_tools.end() || !tool->second)
      return line.malformed("tool", "its data are not in the file, or the robot does not hold it");
    if (!frame) return line.malformed("frame", "its data are not in the file, or it moves");
    return poseInProgram(m_program, *frame, pose, *tool->second);
  }

  // Reads the speed: "v100", "[100,500,5000,1000]", a name of the file; "v100\V:=50". vmax is the largest of the
  // joints.
  void setSpeed(std::string_view text, ParsedMotion& motion) const {
    LineReader line(text, 0);
    std::optional<double> speed;
    if (const auto numbers = line.numbersWithin('[', ']', 20); numbers && !numbers->empty()) {
      speed = numbers->front();
    } else {
      const std::string name = folded(line.name());
      LineReader number(std::string_view(name).substr(std::min<std::size_t>(1, name.size())), 0);
      const auto found = m_speeds.find(name);
      if (found != m_speeds.end())
        speed = found->second.front();
      else if (name == "vmax" && motion.kind == ProgramMotion::Kind::Joint && m_share > 0.0)
        motion.speed = std::min(1.0, m_share);
      else if (name.starts_with('v'))
        speed = number.number();
    }
    if (line.take("\\V") && line.take(":=")) speed = line.number();
    if (!speed || !(*speed * m_share > 0.0)) return;
    (motion.kind == ProgramMotion::Kind::Linear ? motion.speed : motion.toolSpeed) = std::min(*speed * m_share, m_most);
  }

  static std::optional<Pose> poseFrom(const Numbers& n) {
    Eigen::Quaterniond turn(n[3], n[4], n[5], n[6]);
    if (!(turn.norm() > 1e-3) || !(turn.norm() < 1e3)) return std::nullopt;
    Pose pose(Eigen::Translation3d(n[0], n[1], n[2]));
    pose.linear() = turn.normalized().toRotationMatrix();
    return pose;
  }

  // Reads a blend: "z10", "[FALSE,10,…]", a name of the file; "z10\Z:=8". 0 for fine.
  Result<double> blendFrom(std::string_view text, std::size_t number) const {
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

  const RobotProgram& m_program;
  std::size_t m_joints;
  std::optional<ClosedFormIk> m_closed;
  ArmValues m_reference;                        // joint values, as far as the program defines them
  bool m_isConfigurationGiven = true;           // ConfJ\On
  bool m_isLineConfigurationGiven = true;       // ConfL\On
  double m_share = 1.0, m_most = 5'000.0;       // from VelSet; 0: not known
  std::optional<std::string> m_calculatedWith;  // toolText() of CalcRobT in the present motion
  std::string m_targetName;                     // target of the present motion
  Table m_jointTargets, m_robTargets, m_speeds;
  std::map<std::string, std::optional<Pose>> m_tools, m_frames;  // none: unusable
  std::map<std::string, std::optional<double>> m_zones;          // likewise; mm
};

}  // namespace

Result<std::vector<ParsedMotion>> RapidPost::read(std::string_view text, const RobotProgram& frame) const {
  const Result<std::vector<std::string_view>> lines = programLines(text, "!");
  if (!lines) return lines.error();
  const RapidStatements statements(*lines);
  RapidReading reading(frame);
  for (const ProgramStatement& each : statements.data()) {
    if (const Status read = reading.readData(each); !read) return read.error();
  }
  const auto unrolled = statements.routines().unrolled("main", [&](std::string_view statement) {
    LineReader line(statement, 0);
    const std::string name = folded(line.name());
    line.skipSpace();
    return line.rest().empty() ? name : std::string();
  });
  if (!unrolled) return unrolled.error();
  for (const ProgramStatement& each : *unrolled) {
    if (const Status read = reading.read(each); !read) return read.error();
  }
  return std::move(reading.motions);
}

}  // namespace handwheel
