// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/NumberText.h"
#include "robot/posts/ArcPoints.h"
#include "robot/posts/ControllerConfiguration.h"
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/ExternalAxes.h"
#include "robot/posts/PostErrors.h"
#include "robot/posts/PostText.h"
#include "robot/posts/RapidConfiguration.h"
#include "robot/posts/RapidTables.h"

#include <algorithm>
#include <array>
#include <span>

namespace handwheel {

namespace {

// Instructions that neither move the robot nor change the effect of others. Anything that is in no list is refused.
constexpr std::array kRapidStill = {"AccSet", "TPWrite",  "TPErase",  "WaitTime", "WaitDI", "WaitUntil", "WaitRob",
                                    "Stop",   "ClkReset", "ClkStart", "ClkStop",  "Incr",   "Decr"};
// Instructions of this kind by which a tool may grip or release.
constexpr std::array kRapidGripping = {"SetDO", "SetGO", "SetAO", "PulseDO", "Set", "Reset", "InvertDO", "GripLoad"};
// Instructions that end a handler of errors.
constexpr std::array kRapidEnds = {"RETRY", "TRYNEXT", "RETURN", "RAISE", "EXIT", "SkipWarn"};
constexpr const char* kOwnRapidComment = "! To run it: ";  // in the head of modules that we wrote

class RapidReading : public RapidTables {
 public:
  RapidReading(const RobotProgram& program, const RapidStatements& statements)
      : RapidTables(program, statements.scopes()),
        m_joints(static_cast<std::size_t>(program.arm.size())),
        m_closed(closedFormOfSphericalWrist(program.arm)),
        m_reference(ArmValues::Zero(program.arm.size())) {
    for (const std::size_t line : statements.leftOut()) m_kept.leaveOut(line);
  }

  // Keeps the comments outside of procedures, but for those of our own modules.
  void readComments(const std::vector<ProgramStatement>& comments) {
    const auto isOwn = [](const ProgramStatement& each) { return each.text.starts_with(kOwnRapidComment); };
    if (std::ranges::any_of(comments, isOwn)) return;
    for (const ProgramStatement& each : comments)
      m_kept.keep(ProgramLine::Kind::Comment, each.text.substr(1), each.line);
    m_outside = m_kept.before().size();
  }

  // Reads a statement of a trap or a handler of errors. Those that may move the robot are refused: nothing proves
  // where.
  Status readHandler(const ProgramStatement& statement) {
    setScope(statement.scope);
    LineReader line(statement.text, statement.line);
    line.skipSpace();
    std::string_view end = line.rest();
    if (LineReader(line).takeWord("IF")) {  // "IF condition RETRY;"
      while (!end.empty() && (end.back() == ' ' || end.back() == '\t')) end.remove_suffix(1);
      end.remove_prefix(end.find_last_of(" \t)") + 1);
    }
    const auto isEnd = [&](const char* word) { return LineReader(end, 0).takeWord(word); };
    if (line.rest().empty() || (std::ranges::any_of(kRapidEnds, isEnd) && !callsRapidRoutine(line.rest())))
      return Done{};
    return gripOf(line) ? Status(Done{}) : unread(line.rest(), statement.line);
  }

  Status read(const ProgramStatement& statement) {
    setScope(statement.scope);
    LineReader line(statement.text, statement.line);
    if (statement.isComment) {
      m_kept.keep(ProgramLine::Kind::Comment, statement.text.substr(1), statement.line);
      return Done{};
    }
    if (line.takeWord("MoveC")) return readArc(line, statement.line);
    if (line.takeWord("MoveAbsJ")) return readMotion(line, statement.line, ProgramMotion::Kind::Joint, true);
    if (line.takeWord("MoveJ")) return readMotion(line, statement.line, ProgramMotion::Kind::Joint, false);
    if (line.takeWord("MoveL")) return readMotion(line, statement.line, ProgramMotion::Kind::Linear, false);
    const std::optional<bool> mayGrip = gripOf(line);
    if (mayGrip) {
      m_kept.keep(ProgramLine::Kind::Statement, m_declarations.flattened(statement.scope, statement.text),
                  statement.line, *mayGrip);
      return Done{};
    }
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
    return unread(statement.text, statement.line);
  }

  Result<std::vector<ParsedMotion>> takeMotions() {
    const std::vector<ProgramLine> needed = m_declarations.needed();
    std::vector<ProgramLine>& before = m_kept.before();
    before.insert(before.begin() + static_cast<std::ptrdiff_t>(m_outside), needed.begin(), needed.end());
    m_external.addTo(before, externalText());
    return m_kept.take();
  }

 private:
  // Returns true if a tool may grip or release something by a statement that neither moves the robot nor changes the
  // effect of others; nothing for other statements.
  std::optional<bool> gripOf(LineReader line) const {
    LineReader other = line;
    other.name();
    if (callsRapidRoutine(other.rest())) return std::nullopt;
    const auto isOneOf = [&](std::span<const char* const> words) {
      return std::ranges::any_of(words, [&](const char* word) { return LineReader(line).takeWord(word); });
    };
    if (isOneOf(kRapidGripping)) return true;
    // \Wrist and \LockAxis4 let the tool turn on the way of a line.
    LineReader area = line;
    if (isOneOf(kRapidStill) || (area.takeWord("SingArea") && area.take("\\") && area.takeWord("Off"))) return false;
    const std::string_view word = line.name();
    return word.empty() || isData(word) || !isAssignment(line) ? std::nullopt : std::optional(false);
  }

  // Takes the external axes of a target; 9E9: there is no such axis. Returns false if one moves.
  bool takeExternal(std::span<const double> values, std::size_t line) {
    AxisValues axes;
    for (std::size_t i = 0; i < values.size() && i < kExternal; ++i) {
      if (values[i] < ExternalAxes::kNone) axes["eax_" + std::string(1, static_cast<char>('a' + i))] = values[i];
    }
    return m_external.take(axes, line);
  }

  // Returns the external axes as targets have them.
  std::string externalText() const {
    std::string text;
    for (std::size_t i = 0; i < kExternal; ++i) {
      const auto axis = m_external.values().find("eax_" + std::string(1, static_cast<char>('a' + i)));
      text += (i > 0 ? "," : "[") + (axis == m_external.values().end() ? "9E9" : shortestText(axis->second));
    }
    return text + "]";
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
  Result<std::pair<Numbers, bool>> target(LineReader& line, bool isJoints, int depth = 0) {
    constexpr int kDeepest = 16;
    if (depth > kDeepest) return line.malformed("target", "too many functions are within each other");
    if (!isJoints && line.takeWord("CalcRobT")) {
      if (!line.take("(")) return line.malformed("target", "( was expected");
      auto within = target(line, true, depth + 1);
      const std::string_view rest = line.rest();
      std::size_t end = 0;
      for (int open = 1; open > 0 && end < line.rest().size(); ++end)
        open += line.rest()[end] == '(' ? 1 : line.rest()[end] == ')' ? -1 : 0;
      line.skip(end);
      m_calculatedWith = toolText(argumentsOf(rest.substr(0, end > 0 ? end - 1 : 0)), 1);
      return within;
    }
    const bool isOffset = !isJoints && line.takeWord("Offs");
    if (isOffset || (!isJoints && line.takeWord("RelTool"))) return displaced(line, isOffset, depth);
    if (auto numbers = line.numbersWithin('[', ']', 20)) return std::pair(std::move(*numbers), isJoints);
    const std::string_view called = line.name();
    const std::optional<Numbers> found = (isJoints ? m_jointTargets : m_robTargets).find(named(called));
    // The prefix that the post writes.
    constexpr std::string_view kTargetPrefix = "p_";
    m_targetName = readName(called.substr(called.starts_with(kTargetPrefix) ? kTargetPrefix.size() : 0));
    if (line.take("(")) return line.refused(PostError::FunctionUnread, {m_targetName});
    if (!found) return line.malformed("target", "it is neither numbers nor a name given before");
    return std::pair(*found, isJoints);
  }

  // Reads the rest of Offs(target,x,y,z), which moves a target along the axes of its frame, or of
  // RelTool(target,x,y,z\Rx:=…\Ry:=…\Rz:=…), which moves it along the axes of the tool, then turns it about x, the new
  // y and the new z.
  Result<std::pair<Numbers, bool>> displaced(LineReader& line, bool isOffset, int depth) {
    if (!line.take("(")) return line.malformed("target", "( was expected");
    auto read = target(line, false, depth + 1);
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
    const ParsedMotion whole = std::move(m_kept.motions().back());
    m_kept.motions().pop_back();
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
      if (m_kept.isFull()) return line.malformed("MoveC", "there are too many motions");
      const bool isLast = i + 1 == arc->poses.size();
      ParsedMotion part = whole;
      part.pose = arc->poses[i] * held.inverse(Eigen::Isometry);
      part.seconds = whole.seconds / count;
      if (!isLast) {
        part.name.clear();
        part.endsIn.reset();
        part.blend = 0.5 * arc->chord;
      }
      m_kept.add(std::move(part));
    }
    return Done{};
  }

  ArmValues jointsFrom(std::span<const double> degrees) const {
    const ArmValues values = radiansOf(degrees);
    return hasParallelLinkage(m_program.arm) ? countedByModel(m_program.arm, values) : values;
  }

  Status readMotion(LineReader& line, std::size_t number, ProgramMotion::Kind kind, bool wantsJoints) {
    if (m_kept.isFull()) return line.malformed("MoveAbsJ", "there are too many motions");
    while (line.take("\\")) {  // such as \Conc
      m_kept.leaveOut(number);
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
    constexpr std::size_t kBeforeExternal = 11;  // position, orientation, configuration
    const std::size_t first = std::min(numbers.size(), isJoints ? m_joints : kBeforeExternal);
    if (!takeExternal(std::span(numbers).subspan(first), number)) return line.malformed("target", ExternalAxes::kMoved);
    if (isJoints)
      motion.joints = jointsFrom(std::span(numbers).first(m_joints));
    else if (auto pose = poseFrom(numbers))
      motion.pose = *pose;
    else
      return line.malformed("target", "its quaternion has no direction");
    if (callsRapidRoutine(line.rest())) return unread(line.rest(), number);
    const std::vector<std::string_view> arguments = argumentsOf(line.rest());
    LineReader options(arguments.front(), number);
    options.skipSpace();
    if (!options.rest().empty() && !options.rest().starts_with('\\')) return unread(options.rest(), number);
    if (arguments.size() > 1) {
      if (const Status set = setSpeed(arguments[1], number, motion); !set) return set;
      if (!motion.speed && !motion.toolSpeed && !(motion.seconds > 0.0)) m_kept.leaveOut(number);
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
    motion.tool = m_tools.find(named(LineReader(tool, 0).name()));
    if (motion.pose) {
      const auto pose = placed(*motion.pose, tool, number);
      if (!pose) return pose.error();
      motion.pose = *pose;
      if (!takeConfiguration(numbers, motion)) return line.refused(PostError::PoseUnreached);
    }
    if (motion.joints) m_reference = *motion.joints;
    m_flange = motion.joints ? m_program.arm.tipPose(*motion.joints)
                             : Pose(m_program.frame * *motion.pose * m_program.tool.inverse(Eigen::Isometry));
    m_kept.add(std::move(motion));
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
    motion.isAtPose = true;
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
    const std::optional<Pose> tool = m_tools.find(named(line.name())), frame = frameIn(text);
    if (line.take("\\WObj") && line.take(":=")) line.name();
    line.skipSpace();
    if (!line.rest().empty()) return unread(line.rest(), number);
    if (!tool || !frame) return line.refused(PostError::DataElsewhere);
    return poseInProgram(m_program, *frame, pose, *tool);
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
      const auto found = m_speeds.find(named(name));
      if (found)
        speed = found->front();
      else if (m_speeds.contains(named(name)))
        speed = std::nullopt;
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
  static constexpr std::size_t kExternal = 6;
  ExternalAxes m_external;
  KeptLines m_kept;
  std::size_t m_outside = 0;  // number of comments outside of procedures
};

}  // namespace

Result<std::vector<ParsedMotion>> RapidPost::read(std::string_view text, const RobotProgram& frame) const {
  const Result<std::string> plain = programText(text);
  if (!plain) return plain.error();
  const Result<std::vector<std::string_view>> lines = programLines(*plain, {});
  if (!lines) return lines.error();
  const RapidStatements statements(*lines);
  RapidReading reading(frame, statements);
  reading.readComments(statements.comments());
  for (const RapidData& each : statements.data()) {
    if (const Status read = reading.readData(each); !read) return read.error();
  }
  for (const ProgramStatement& each : statements.conditions()) {
    LineReader condition(each.text, each.line);
    condition.name();  // IF
    if (callsRapidRoutine(condition.rest())) return unread(each.text, each.line);
  }
  for (const ProgramStatement& each : statements.handlers()) {
    if (const Status read = reading.readHandler(each); !read) return read.error();
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
