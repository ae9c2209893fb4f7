// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ArcPoints.h"
#include "robot/posts/ControllerConfiguration.h"
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/PostText.h"
#include "robot/posts/RapidConfiguration.h"
#include "robot/posts/RapidTables.h"

#include <algorithm>
#include <array>
#include <span>

namespace handwheel {

namespace {

// Instructions that neither move the robot nor change the effect of others. Anything that is in no list is refused.
constexpr std::array kRapidStill = {"AccSet",  "SingArea", "TPWrite",  "TPErase",  "WaitTime", "WaitDI", "WaitUntil",
                                    "WaitRob", "Stop",     "ClkReset", "ClkStart", "ClkStop",  "Incr",   "Decr"};
// Instructions of this kind by which a tool may grip or release.
constexpr std::array kRapidGripping = {"SetDO", "SetGO", "SetAO", "PulseDO", "Set", "Reset", "InvertDO", "GripLoad"};
constexpr const char* kOwnRapidComment = "! To run it: ";  // in the head of modules that we wrote

class RapidReading : public RapidTables {
 public:
  explicit RapidReading(const RobotProgram& program)
      : RapidTables(program),
        m_joints(static_cast<std::size_t>(program.arm.size())),
        m_closed(closedFormOfSphericalWrist(program.arm)),
        m_reference(ArmValues::Zero(program.arm.size())) {}

  // Keeps the comments outside of procedures, but for those of our own modules.
  void readComments(const std::vector<ProgramStatement>& comments) {
    const auto isOwn = [](const ProgramStatement& each) { return each.text.starts_with(kOwnRapidComment); };
    if (std::ranges::any_of(comments, isOwn)) return;
    for (const ProgramStatement& each : comments)
      m_before.push_back(keptLine(ProgramLine::Kind::Comment, each.text.substr(1), each.line));
  }

  Status read(const ProgramStatement& statement) {
    LineReader line(statement.text, statement.line);
    if (statement.isComment) {
      keep(ProgramLine::Kind::Comment, statement.text.substr(1), statement.line);
      return Done{};
    }
    if (line.takeWord("MoveC")) return readArc(line, statement.line);
    if (line.takeWord("MoveAbsJ")) return readMotion(line, statement.line, ProgramMotion::Kind::Joint, true);
    if (line.takeWord("MoveJ")) return readMotion(line, statement.line, ProgramMotion::Kind::Joint, false);
    if (line.takeWord("MoveL")) return readMotion(line, statement.line, ProgramMotion::Kind::Linear, false);
    LineReader other = line;
    other.name();
    if (callsRapidRoutine(other.rest())) return unread(statement.text, statement.line);
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
    const auto isOneOf = [&](std::span<const char* const> words) {
      return std::ranges::any_of(words, [&](const char* word) { return LineReader(line).takeWord(word); });
    };
    const bool mayGrip = isOneOf(kRapidGripping);
    if (mayGrip || isOneOf(kRapidStill)) {
      keep(ProgramLine::Kind::Statement, statement.text, statement.line, mayGrip);
      return Done{};
    }
    const std::string_view word = line.name();
    if (word.empty() || isData(folded(word)) || !isAssignment(line)) return unread(statement.text, statement.line);
    keep(ProgramLine::Kind::Statement, statement.text, statement.line);
    return Done{};
  }

  std::vector<ParsedMotion> takeMotions() {
    if (!m_motions.empty()) m_motions.front().before = std::move(m_before);
    return std::move(m_motions);
  }

 private:
  void keep(ProgramLine::Kind kind, std::string_view text, std::size_t number, bool mayGrip = false) {
    (m_motions.empty() ? m_before : m_motions.back().lines).push_back(keptLine(kind, text, number, mayGrip));
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
    const bool isOffset = !isJoints && line.takeWord("Offs");
    if (isOffset || (!isJoints && line.takeWord("RelTool"))) return displaced(line, isOffset);
    if (auto numbers = line.numbersWithin('[', ']', 20)) return std::pair(std::move(*numbers), isJoints);
    const Table& known = isJoints ? m_jointTargets : m_robTargets;
    const std::string_view called = line.name();
    const auto found = known.find(folded(called));
    // The prefix that the post writes.
    constexpr std::string_view kTargetPrefix = "p_";
    m_targetName = readName(called.substr(called.starts_with(kTargetPrefix) ? kTargetPrefix.size() : 0));
    if (line.take("(")) return line.malformed("target", "functions but Offs and RelTool are not read");
    if (found == known.end()) return line.malformed("target", "it is neither numbers nor a name given before");
    return std::pair(found->second, isJoints);
  }

  // Reads the rest of Offs(target,x,y,z), which moves a target along the axes of its frame, or of
  // RelTool(target,x,y,z\Rx:=…\Ry:=…\Rz:=…), which moves it along the axes of the tool, then turns it about x, the new
  // y and the new z.
  Result<std::pair<Numbers, bool>> displaced(LineReader& line, bool isOffset) {
    if (!line.take("(")) return line.malformed("target", "( was expected");
    auto read = target(line, false);
    if (!read) return read;
    Numbers& numbers = read->first;
    m_targetName.clear();
    const std::string_view rest = line.rest();
    const std::size_t end = rest.find(')');
    const auto pose = numbers.size() >= 7 ? poseFrom(numbers) : std::nullopt;
    const std::vector<std::string_view> arguments = argumentsOf(rest.substr(0, std::min(end, rest.size())));
    if (!pose || end == rest.npos || arguments.size() != 4 || read->second)
      return line.malformed("target", "a target and three numbers were expected");
    line.skip(end + 1);
    std::string_view last = arguments[3];
    std::array<std::string_view, 3> turns = {};
    const std::size_t options = std::min(last.find('\\'), last.size());
    for (LineReader option(last.substr(options), 0); option.take("\\");) {
      const std::string_view text = option.rest().substr(0, option.rest().find('\\'));
      LineReader named(text, 0);
      const std::string name = folded(named.name());
      const std::size_t axis = name == "rx" ? 0 : name == "ry" ? 1 : name == "rz" ? 2 : turns.size();
      if (isOffset || axis == turns.size() || !named.take(":=")) return unread(option.rest(), 0);
      turns[axis] = named.rest();
      option.skip(text.size());
    }
    last = last.substr(0, options);
    Vec3 shift, turn = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = numberIn(i == 2 ? last : arguments[i + 1]);
      const auto degrees = turns[i].empty() ? std::optional(0.0) : numberIn(turns[i]);
      if (!value || !degrees)
        return line.malformed("target", "its displacement is neither a number nor a CONST num of the module");
      shift[static_cast<Eigen::Index>(i)] = *value;
      turn[static_cast<Eigen::Index>(i)] = *degrees * kRadiansPerDegree;
    }
    const Vec3 at = pose->translation() + (isOffset ? shift : Vec3(pose->linear() * shift));
    const Eigen::Quaterniond turned(pose->linear() * Eigen::AngleAxisd(turn.x(), Vec3::UnitX()) *
                                    Eigen::AngleAxisd(turn.y(), Vec3::UnitY()) *
                                    Eigen::AngleAxisd(turn.z(), Vec3::UnitZ()));
    const double changed[] = {at.x(), at.y(), at.z(), turned.w(), turned.x(), turned.y(), turned.z()};
    std::ranges::copy(changed, numbers.begin());
    return read;
  }

  // Reads "MoveC middle,end,speed,zone,tool" as short lines.
  Status readArc(LineReader& line, std::size_t number) {
    constexpr double kDeviation = 0.01, kMostAngle = M_PI + 1e-6;  // mm, rad
    while (line.take("\\")) {
      line.name();
      line.take(",");
    }
    const auto middle = target(line, false);
    if (!middle) return middle.error();
    const auto middlePose = middle->first.size() >= 7 && !middle->second ? poseFrom(middle->first) : std::nullopt;
    if (!middlePose || !line.take(",")) return line.malformed("target", "a place on the arc was expected");
    const std::vector<std::string_view> arguments = argumentsOf(line.rest());
    const std::string_view tool = arguments.size() > 3 ? arguments[3] : "";
    const std::optional<Pose> from = m_flange;
    if (!from) return line.malformed("target", "the start of the arc is not known");
    if (const Status read = readMotion(line, number, ProgramMotion::Kind::Linear, false); !read) return read;
    const ParsedMotion whole = std::move(m_motions.back());
    m_motions.pop_back();
    if (!whole.pose) return unread("MoveC", number);
    const Result<Pose> through = placed(*middlePose, tool, number);
    if (!through) return through.error();
    const Pose start = m_program.frame.inverse(Eigen::Isometry) * *from * m_program.tool;
    const Pose held = m_program.tool.inverse(Eigen::Isometry) * whole.tool.value_or(m_program.tool);  // its own tool
    const auto arc = pointsOfArc(start * held, (*through * held).translation(), *whole.pose * held, kDeviation);
    if (!arc) return line.malformed("target", "the three places of the arc are in a line");
    if (arc->angle > kMostAngle)
      return line.malformed("target", "the arc is longer than half a circle: divide it into two");
    if (arc->turn > kMostAngle)
      return line.malformed("target", "the tool turns by more than half a turn along the arc: divide it into two");
    const auto count = static_cast<double>(arc->poses.size());
    for (std::size_t i = 0; i < arc->poses.size(); ++i) {
      if (m_motions.size() >= PostProcessor::kMostMotions) return line.malformed("MoveC", "there are too many motions");
      const bool isLast = i + 1 == arc->poses.size();
      ParsedMotion part = whole;
      part.pose = arc->poses[i] * held.inverse(Eigen::Isometry);
      part.seconds = whole.seconds / count;
      if (!isLast) {
        part.name.clear();
        part.endsIn.reset();
        part.blend = 0.5 * arc->chord;
      }
      m_motions.push_back(std::move(part));
    }
    return Done{};
  }

  ArmValues jointsFrom(std::span<const double> degrees) const {
    const ArmValues values = radiansOf(degrees);
    return hasParallelLinkage(m_program.arm) ? countedByModel(m_program.arm, values) : values;
  }

  Status readMotion(LineReader& line, std::size_t number, ProgramMotion::Kind kind, bool wantsJoints) {
    if (m_motions.size() >= PostProcessor::kMostMotions)
      return line.malformed("MoveAbsJ", "there are too many motions");
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
      motion.joints = jointsFrom(std::span(numbers).first(m_joints));
    else if (auto pose = poseFrom(numbers))
      motion.pose = *pose;
    else
      return line.malformed("target", "its quaternion has no direction");
    if (callsRapidRoutine(line.rest())) return unread(line.rest(), number);
    const std::vector<std::string_view> arguments = argumentsOf(line.rest());
    if (arguments.size() > 1) {
      if (const Status set = setSpeed(arguments[1], number, motion); !set) return set;
    }
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
    m_flange = motion.joints ? m_program.arm.tipPose(*motion.joints)
                             : Pose(m_program.frame * *motion.pose * m_program.tool.inverse(Eigen::Isometry));
    m_motions.push_back(std::move(motion));
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
  // joints. "v100\T:=10" demands a duration.
  Status setSpeed(std::string_view text, std::size_t number, ParsedMotion& motion) const {
    LineReader line(text, 0);
    std::optional<double> speed;
    if (const auto numbers = line.numbersWithin('[', ']', 20); numbers && !numbers->empty()) {
      speed = numbers->front();
    } else {
      const std::string name = folded(line.name());
      LineReader digits(std::string_view(name).substr(std::min<std::size_t>(1, name.size())), 0);
      const auto found = m_speeds.find(name);
      if (found != m_speeds.end())
        speed = found->second.front();
      else if (name == "vmax" && motion.kind == ProgramMotion::Kind::Joint && m_share > 0.0)
        motion.speed = std::min(1.0, m_share);
      else if (name.starts_with('v'))
        speed = digits.number();
    }
    const bool isTimed = line.takeWord("\\T");
    if (isTimed || line.takeWord("\\V")) {
      const auto value = line.take(":=") ? numberIn(line.rest()) : std::nullopt;
      if (!value || !(*value > 0.0) || (isTimed && *value > ProgramMotion::kLongest)) return unread(text, number);
      if (isTimed)
        motion.seconds = *value;
      else
        speed = value;
    }
    if (!speed || !(*speed * m_share > 0.0)) return Done{};
    (motion.kind == ProgramMotion::Kind::Linear ? motion.speed : motion.toolSpeed) = std::min(*speed * m_share, m_most);
    return Done{};
  }

  std::size_t m_joints;
  std::optional<ClosedFormIk> m_closed;
  ArmValues m_reference;                        // joint values, as far as the program defines them
  bool m_isConfigurationGiven = true;           // ConfJ\On
  bool m_isLineConfigurationGiven = true;       // ConfL\On
  double m_share = 1.0, m_most = 5'000.0;       // from VelSet; 0: not known
  std::optional<std::string> m_calculatedWith;  // toolText() of CalcRobT in the present motion
  std::string m_targetName;                     // target of the present motion
  std::optional<Pose> m_flange;                 // in the base, at the end of the last motion
  std::vector<ParsedMotion> m_motions;
};

}  // namespace

Result<std::vector<ParsedMotion>> RapidPost::read(std::string_view text, const RobotProgram& frame) const {
  const Result<std::vector<std::string_view>> lines = programLines(text, {});
  if (!lines) return lines.error();
  const RapidStatements statements(*lines);
  RapidReading reading(frame);
  reading.readComments(statements.comments());
  for (const RapidData& each : statements.data()) {
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
  return reading.takeMotions();
}

}  // namespace handwheel
