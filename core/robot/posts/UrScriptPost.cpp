// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/KeptLines.h"
#include "robot/posts/PostText.h"
#include "robot/posts/ProgramRoutines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace handwheel {

namespace {

constexpr double kMetresOfMillimetre = 1e-3;

// Keywords of URScript, and the functions that programs commonly call.
constexpr const char* kUrWords[] = {
    "and",    "break", "continue", "def",    "elif",   "else",        "end",     "enter_critical", "exit_critical",
    "false",  "for",   "global",   "halt",   "if",     "in",          "join",    "kill",           "local",
    "mod",    "movec", "movej",    "movel",  "movep",  "not",         "or",      "pass",           "popup",
    "return", "run",   "sec",      "servoc", "servoj", "set_payload", "set_tcp", "sleep",          "speedj",
    "speedl", "stopj", "stopl",    "struct", "sync",   "textmsg",     "thread",  "true",           "wait",
    "while",  "xor"};

// Formats a pose: X, Y, Z in metres and a rotation as an axis of the length of its angle.
std::string urPose(const Pose& pose) {
  const Vec3 at = kMetresOfMillimetre * pose.translation();
  const Eigen::AngleAxisd turn(pose.linear());
  const Vec3 rotation = turn.angle() * turn.axis();
  const double numbers[] = {at.x(), at.y(), at.z(), rotation.x(), rotation.y(), rotation.z()};
  return "p[" + fixedList(numbers, 9) + "]";
}

// Returns the speed, rad/s, that all joints can reach; revolute joints without a known velocity turn 180° per second.
double urFullSpeed(const RobotProgram& program) {
  double fastest = M_PI;
  for (const ArmJoint& joint : program.arm.joints()) fastest = std::min(fastest, joint.velocity.value_or(M_PI));
  return fastest;
}

// Returns the zone of a motion, mm. Zones of neighbours must not overlap, and the last motion has none.
double zoneOf(const RobotProgram& program, std::size_t i) {
  if (i == 0 || i + 1 >= program.motions.size()) return 0.0;
  const auto at = [&](std::size_t k) { return Vec3(program.tipOf(program.motions[k]).translation()); };
  const double near = std::min((at(i) - at(i - 1)).norm(), (at(i + 1) - at(i)).norm());
  return std::min(program.motions[i].blend, 0.49 * near);
}

// Functions without side effects, and operators before brackets. Others may be routines that move the robot.
constexpr const char* kUrFunctions[] = {"acos",
                                        "and",
                                        "asin",
                                        "atan",
                                        "atan2",
                                        "ceil",
                                        "cos",
                                        "d2r",
                                        "floor",
                                        "get_actual_joint_positions",
                                        "get_actual_tcp_pose",
                                        "get_analog_in",
                                        "get_digital_in",
                                        "get_forward_kin",
                                        "get_inverse_kin",
                                        "get_standard_analog_in",
                                        "get_standard_digital_in",
                                        "get_target_joint_positions",
                                        "get_target_tcp_pose",
                                        "get_tool_digital_in",
                                        "interpolate_pose",
                                        "length",
                                        "log",
                                        "mod",
                                        "norm",
                                        "not",
                                        "or",
                                        "point_dist",
                                        "pose_add",
                                        "pose_dist",
                                        "pose_inv",
                                        "pose_sub",
                                        "pose_trans",
                                        "pow",
                                        "r2d",
                                        "rotvec2rpy",
                                        "rpy2rotvec",
                                        "sin",
                                        "sqrt",
                                        "tan",
                                        "to_num",
                                        "to_str",
                                        "xor"};

// The arguments of a motion after its target: "v=0.5", or without names in the order of the language.
class UrArguments {
 public:
  // Parses the rest of a call after its target, with the closing bracket. isWhole() is false if something follows.
  explicit UrArguments(std::string_view rest) {
    while (!rest.empty() && (rest.back() == ' ' || rest.back() == '\t' || rest.back() == '\r')) rest.remove_suffix(1);
    m_isWhole = rest.ends_with(')') &&
                std::count(rest.begin(), rest.end(), ')') == 1 + std::count(rest.begin(), rest.end(), '(');
    if (m_isWhole) rest.remove_suffix(1);
    m_parts = argumentsOf(rest);
  }
  bool isWhole() const { return m_isWhole; }

  // index: position after the target, from 1. none: it is not given.
  std::optional<std::string_view> text(std::string_view name, std::size_t index) const {
    for (std::size_t i = 1; i < m_parts.size(); ++i) {
      LineReader part(m_parts[i], 0);
      const std::string_view own = part.name();
      const bool isNamed = !own.empty() && part.take("=") && !part.rest().starts_with('=');
      if (isNamed ? own == name : i == index) return isNamed ? part.rest() : m_parts[i];
    }
    return std::nullopt;
  }

 private:
  std::vector<std::string_view> m_parts;
  bool m_isWhole = false;
};

// Converts six numbers: metres, and a rotation as an axis of the length of its angle.
Pose urPoseOf(std::span<const double> n) {
  const Vec3 turn(n[3], n[4], n[5]);
  Pose pose(Eigen::Translation3d(Vec3(n[0], n[1], n[2]) / kMetresOfMillimetre));
  if (turn.norm() > 0.0) pose.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  return pose;
}

// The variables to which a program has assigned numbers: poses in the base, joint values.
struct UrVariables {
  std::map<std::string, Pose, std::less<>> poses;
  std::map<std::string, ArmValues, std::less<>> joints;
};

constexpr std::string_view kUrFramePrefix = "frame_";  // prefix of our frames

// Reads "p[…]", "[…]" or the name of a variable into the motion. Errors: ElementMalformed.
Status urNumbers(LineReader& line, const UrVariables& variables, ParsedMotion& motion) {
  LineReader named = line;
  const std::string_view name = named.name();
  named.skipSpace();
  if (!name.empty() && !(name == "p" && named.rest().starts_with('['))) {
    const auto pose = variables.poses.find(name);
    const auto joints = variables.joints.find(name);
    if (pose != variables.poses.end())
      motion.pose = pose->second;
    else if (joints != variables.joints.end())
      motion.joints = joints->second;
    else
      return line.malformed("target", "it is neither numbers nor a variable that was given numbers before");
    line = named;
    return Done{};
  }
  const bool isPose = line.take("p");
  const auto numbers = line.numbersWithin('[', ']', 6);
  if (!numbers || numbers->size() != 6) return line.malformed("target", "six numbers in brackets were expected");
  if (isPose)
    motion.pose = urPoseOf(*numbers);
  else
    motion.joints = Eigen::Map<const Eigen::VectorXd>(numbers->data(), 6);
  return Done{};
}

// Reads a target. movep(pose, a, v, r) has no time; the others are movej(q, a, v, t, r). A pose may be
// pose_trans(frame,p[…]).
Result<ParsedMotion> urTarget(LineReader& line, std::size_t number, ProgramMotion::Kind kind, bool hasTime,
                              const UrVariables& variables) {
  ParsedMotion motion{kind, {}, {}, 0.0, number};
  const std::string_view call = line.rest();
  if (!line.take("(")) return line.malformed("target", "numbers in brackets were expected");
  const bool isInFrame = line.takeWord("pose_trans");
  if (isInFrame) {
    const auto frame = line.take("(") ? variables.poses.find(line.name()) : variables.poses.end();
    if (frame == variables.poses.end() || !line.take(",")) return unread(call, number);
    motion.frame = frame->second;
    const std::string_view name = frame->first;
    motion.frameName = readName(name.substr(name.starts_with(kUrFramePrefix) ? kUrFramePrefix.size() : 0));
  }
  if (const Status read = urNumbers(line, variables, motion); !read) return read.error();
  if (isInFrame && (!motion.pose || !line.take(")"))) return unread(call, number);
  const UrArguments arguments(line.rest());
  if (!arguments.isWhole() || callsOther(line.rest(), kUrFunctions)) return unread(call, number);
  const std::string_view zone = arguments.text("r", hasTime ? 4 : 3).value_or("0");
  const auto radius = numberAlone(zone);
  if (!radius || !(*radius >= 0.0)) return unread(zone, number);
  motion.blend = *radius / kMetresOfMillimetre;
  motion.speed = numberAlone(arguments.text("v", 2).value_or(""));
  const std::string_view time = hasTime ? arguments.text("t", 3).value_or("0") : "0";
  const auto seconds = numberAlone(time);
  if (!seconds || !(*seconds >= 0.0 && *seconds <= ProgramMotion::kLongest)) return unread(time, number);
  motion.seconds = *seconds;
  if (motion.seconds > 0.0 || !(motion.speed.value_or(0.0) > 0.0)) motion.speed = std::nullopt;
  if (!motion.speed && !(motion.seconds > 0.0) && arguments.text("v", 2)) motion.leftOut = {number};
  return motion;
}

std::string urFunctionName(const RobotProgram& program) {
  std::vector<const char*> words(std::begin(kUrWords), std::end(kUrWords));
  const std::set<std::string> names = keptNames(program, "urscript");
  for (const std::string& name : names) words.push_back(name.c_str());
  return identifierBeside(words, program.name, 60);
}

// Returns true if lines lead to poses in the frame of the cell, which is then a variable of this name. A pose has to be
// in the controller's base, and ROS' base_link is turned by 180° against that.
bool isInUrFrame(const RobotProgram& program) {
  return program.isBaseOfController && !program.frameName.empty();
}
// Returns the name of the frame's variable, distinct from the function, which cannot be assigned.
std::string urFrameName(const RobotProgram& program) {
  std::set<std::string> taken = keptNames(program, "urscript");
  taken.insert(lowerCase(urFunctionName(program)));
  const std::string name = std::string(kUrFramePrefix) + frameIdentifier(program, {}, 50);
  std::string free = name;
  for (int n = 1; taken.contains(lowerCase(free)); ++n) free = name + "_" + std::to_string(n);
  return free;
}

std::string urMotion(const RobotProgram& program, std::size_t i) {
  const ProgramMotion& motion = program.motions[i];
  const bool isJoint = motion.kind == ProgramMotion::Kind::Joint;
  constexpr double kRampsASecond = 4.0;  // full speed after a quarter of a second
  const double speed = isJoint ? urFullSpeed(program) * std::clamp(motion.speed, 0.001, 1.0)
                               : kMetresOfMillimetre * std::max(motion.speed, 0.01);
  // movel uses joint values, too: the controller computes the pose by its own kinematics, with the TCP set above.
  std::string text = motion.name.empty() ? "" : "  # " + identifierOf(motion.name, 60) + "\n";
  if (!isJoint && isInUrFrame(program)) {
    const Pose pose = program.frame.inverse(Eigen::Isometry) * program.tipOf(motion);
    text += "  movel(pose_trans(" + urFrameName(program) + "," + urPose(pose) + ")";
  } else {
    text += std::string(isJoint ? "  movej([" : "  movel([") + fixedList(std::span(motion.joints.data(), 6), 9) + "]";
  }
  if (motion.seconds > 0.0) text += ",t=" + fixedText(motion.seconds, 3);
  text += ",a=" + fixedText(kRampsASecond * speed, 7) + ",v=" + fixedText(speed, 7);
  return text + ",r=" + fixedText(kMetresOfMillimetre * zoneOf(program, i), 6) + ")\n";
}

// Calls of the language that neither move the robot nor change the effect of others. Anything that is in no list is
// refused.
constexpr std::array kUrStill = {"set_gravity", "sleep", "sync", "textmsg", "popup", "stopj", "stopl"};
// Calls of this kind by which a tool may grip or release.
constexpr std::array kUrGripping = {"set_payload",
                                    "set_target_payload",
                                    "set_digital_out",
                                    "set_standard_digital_out",
                                    "set_configurable_digital_out",
                                    "set_tool_digital_out",
                                    "set_analog_out",
                                    "set_standard_analog_out",
                                    "set_tool_voltage"};
// Comments that we write into programs; kAssumedLoad, and kUnusedFrame for the frame of a program without lines in it.
constexpr std::string_view kAssumedLoad = "# The load is that of the installation.", kUnusedFrame = "# The frame ";

class UrScriptReading {
 public:
  UrScriptReading(const RobotProgram& program, bool isOwn) : m_program(program), m_tool(program.tool), m_isOwn(isOwn) {}

  Result<std::vector<ParsedMotion>> takeMotions() { return m_kept.take(); }

  Status read(const ProgramStatement& statement) {
    LineReader line(statement.text, statement.line);
    if (statement.isComment) {
      readComment(statement);
      return Done{};
    }
    if (line.takeWord("movej")) return readMotion(line, statement, ProgramMotion::Kind::Joint, true);
    if (line.takeWord("movel")) return readMotion(line, statement, ProgramMotion::Kind::Linear, true);
    if (line.takeWord("movep")) return readMotion(line, statement, ProgramMotion::Kind::Linear, false);
    if (line.takeWord("set_tcp")) return setTool(line);
    const auto takesOneOf = [&](std::span<const char* const> words) {
      return std::ranges::any_of(words, [&](const char* word) { return line.takeWord(word); });
    };
    const bool mayGrip = takesOneOf(kUrGripping);
    if (mayGrip || takesOneOf(kUrStill)) {
      if (callsOther(line.rest(), kUrFunctions)) return unread(statement.text, statement.line);
      m_kept.keep(ProgramLine::Kind::Statement, statement.text, statement.line, mayGrip);
      return Done{};
    }
    const bool isGlobal = line.takeWord("global"), isLocal = !isGlobal && line.takeWord("local");
    const std::string name(line.name());
    const bool isAssignment = !name.empty() && line.take("=") && !line.take("=");
    const bool isOfAnother = isAssignment && !own(name, isGlobal, isLocal, statement.scope);
    if (!isAssignment || isOfAnother || callsOther(line.rest(), kUrFunctions))
      return unread(statement.text, statement.line);
    const bool isConstant = assign(name, line);
    const bool isOwnFrame = m_isOwn && isConstant && name.starts_with(kUrFramePrefix);
    if (!isOwnFrame)
      m_kept.keep(isConstant ? ProgramLine::Kind::Declaration : ProgramLine::Kind::Statement, statement.text,
                  statement.line);
    return Done{};
  }

 private:
  static constexpr std::size_t kGlobal = 0;  // scope of what is outside of functions
  struct Owner {
    std::size_t scope = kGlobal;  // function of the variable
    bool isLocal = false;         // it is declared so
  };

  // Notes the function in which a variable is assigned. Returns false if it hides the variable of another function, or
  // if the language leaves open whether it does: then nobody knows what its name means elsewhere.
  bool own(const std::string& name, bool isGlobal, bool isLocal, std::size_t scope) {
    const Owner owner{isGlobal ? kGlobal : scope, isLocal};
    const auto [known, isNew] = m_owners.emplace(name, owner);
    if (isNew) return true;
    if (known->second.scope == owner.scope) return known->second.isLocal || !isLocal;
    return known->second.scope == kGlobal && !isLocal;
  }

  // Assigns a variable. Returns true if it is a pose or joint values in numbers from now on.
  bool assign(const std::string& name, LineReader value) {
    const bool isPose = value.take("p");
    const auto numbers = value.numbersWithin('[', ']', 6);
    value.skipSpace();
    m_variables.poses.erase(name);
    m_variables.joints.erase(name);
    if (!numbers || numbers->size() != 6 || !value.rest().empty()) return false;
    if (isPose)
      m_variables.poses[name] = urPoseOf(*numbers);
    else
      m_variables.joints[name] = Eigen::Map<const Eigen::VectorXd>(numbers->data(), 6);
    return true;
  }

  void readComment(const ProgramStatement& comment) {
    if (m_isOwn && (comment.text.starts_with(kAssumedLoad) || comment.text.starts_with(kUnusedFrame))) return;
    const std::string name = m_isOwn ? nameInComment(comment.text) : std::string();
    if (name.empty())
      m_kept.keep(ProgramLine::Kind::Comment, comment.text.substr(1), comment.line);
    else
      m_nextName = name;
  }

  Status setTool(LineReader& line) {
    const auto numbers = line.take("(") && line.take("p") ? line.numbersWithin('[', ']', 6) : std::nullopt;
    if (!numbers || numbers->size() != 6) return line.malformed("tool", "six numbers in brackets were expected");
    m_tool = urPoseOf(*numbers);
    m_isToolSet = true;
    return Done{};
  }

  Status readMotion(LineReader& line, const ProgramStatement& statement, ProgramMotion::Kind kind, bool hasTime) {
    const std::size_t number = statement.line;
    if (m_kept.isFull()) return line.malformed("movej", "there are too many motions");
    const auto isOfAnother = [&](const std::string_view name) {
      const auto owner = m_owners.find(name);
      return owner != m_owners.end() && owner->second.isLocal && owner->second.scope != statement.scope;
    };
    LineReader target = line;
    target.take("(");
    if (target.takeWord("pose_trans")) target.take("(");
    const std::string_view frame = target.name();
    target.take(",");
    if (isOfAnother(frame) || isOfAnother(target.name()))
      return line.malformed("target", "it is neither numbers nor a variable that was given numbers before");
    Result<ParsedMotion> motion = urTarget(line, number, kind, hasTime, m_variables);
    if (!motion) return motion.error();
    motion->name = std::exchange(m_nextName, {});
    if (motion->speed && kind == ProgramMotion::Kind::Joint)
      motion->speed = std::min(1.0, *motion->speed / urFullSpeed(m_program));
    else if (motion->speed)
      *motion->speed /= kMetresOfMillimetre;
    if (motion->pose)
      motion->pose = poseInProgram(m_program, motion->frame.value_or(Pose(Pose::Identity())), *motion->pose, m_tool);
    if (m_isToolSet) motion->tool = m_tool;
    for (const std::size_t left : motion->leftOut) m_kept.leaveOut(left);
    motion->leftOut.clear();
    motion->isInControllersBase = motion->pose.has_value();
    m_kept.add(std::move(motion).value());
    return Done{};
  }

  const RobotProgram& m_program;
  Pose m_tool;  // in the flange: that of the cell until the program sets another
  bool m_isToolSet = false, m_isOwn;
  UrVariables m_variables;
  std::string m_nextName;                              // name of the next motion's waypoint
  std::map<std::string, Owner, std::less<>> m_owners;  // functions of variables
  KeptLines m_kept;
};

// Splits the program into functions. Blocks within them end like these do. isOwn: comments outside of functions are
// those that we wrote.
ProgramRoutines urRoutines(const std::vector<ProgramStatement>& statements, bool isOwn) {
  ProgramRoutines routines;
  std::vector<bool> areBlocks;            // open statements
  std::vector<std::size_t> functions{0};  // numbers of the open functions
  std::size_t count = 0;
  for (ProgramStatement statement : statements) {
    statement.scope = functions.back();
    LineReader line(statement.text, statement.line);
    if (statement.isComment && areBlocks.empty() && isOwn) continue;
    if (line.takeWord("def")) {
      areBlocks.push_back(false);
      functions.push_back(++count);
      routines.begin(std::string(line.name()), statement.line);
    } else if (line.takeWord("end")) {
      if (!areBlocks.empty() && !areBlocks.back()) {
        routines.end();
        functions.pop_back();
      }
      if (!areBlocks.empty()) areBlocks.pop_back();
    } else {
      routines.add(statement);
      if (line.takeWord("if") || line.takeWord("while") || line.takeWord("for") || line.takeWord("thread"))
        areBlocks.push_back(true);
    }
  }
  return routines;
}

}  // namespace

std::string UrScriptPost::write(const RobotProgram& program) const {
  const std::string name = urFunctionName(program);
  RobotProgram head = program;
  if (!isInUrFrame(program)) head.frameName.clear();
  std::string text;
  for (const std::string& remark : headRemarks(head)) text += "# " + remark + "\n";
  text += "def " + name + "():\n  set_tcp(" + urPose(program.tool) + ")\n";
  text += "  " + std::string(kAssumedLoad) + " An assumption was: set_payload(" +
          fixedText(std::max(0.001, program.toolMass), 3) + ")\n";
  if (isInUrFrame(program))
    text += "  " + urFrameName(program) + " = " + urPose(program.frame) + "\n";
  else if (!program.frameName.empty())
    text += "  " + std::string(kUnusedFrame) + identifierOf(program.frameName, 60) +
            " in the base of the robot's description, not used here: " + urPose(program.frame) + "\n";
  text += keptTexts(program.head, "  ", "#", "");
  for (std::size_t i = 0; i < program.motions.size(); ++i)
    text += urMotion(program, i) + keptTexts(program.motions[i].lines, "  ", "#", "");
  return text + "end\n\n# Leave this call out where the file is sent to a port of the controller.\n" + name + "()\n";
}

// Poses of URScript are in the controller's base, which is treated here as the arm's, and in the program's frame.
Result<std::vector<ParsedMotion>> UrScriptPost::read(std::string_view text, const RobotProgram& frame) const {
  const Result<std::string> plain = programText(text);
  if (!plain) return plain.error();
  const Result<std::vector<std::string_view>> lines = programLines(*plain, {});
  if (!lines) return lines.error();
  const bool isOwn = text.find(std::string("# ") + kWrittenByUs) != std::string_view::npos;
  const auto unrolled = urRoutines(statementsOf(*lines, "#"), isOwn).unrolled({}, [](std::string_view statement) {
    LineReader line(statement, 0);
    const std::string name(line.name());
    const bool isCall = line.take("(") && line.take(")");
    line.skipSpace();
    return isCall && line.rest().empty() ? name : std::string();
  });
  if (!unrolled) return unrolled.error();
  UrScriptReading reading(frame, isOwn);
  for (const ProgramStatement& each : *unrolled) {
    if (const Status read = reading.read(each); !read) return read.error();
  }
  return reading.takeMotions();
}

}  // namespace handwheel
