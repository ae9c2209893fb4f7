// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ControllerPosts.h"
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

using UrFrames = std::map<std::string, Pose, std::less<>>;  // variables that a program has given poses, in the base

constexpr std::string_view kUrFramePrefix = "frame_";  // prefix of our frames

// Reads a target. movep(pose, a, v, r) has no time; the others are movej(q, a, v, t, r). A pose may be
// pose_trans(frame,p[…]).
Result<ParsedMotion> urTarget(LineReader& line, std::size_t number, ProgramMotion::Kind kind, bool hasTime,
                              const UrFrames& frames) {
  ParsedMotion motion{kind, {}, {}, 0.0, number};
  const std::string_view call = line.rest();
  if (!line.take("(")) return line.malformed("target", "numbers in brackets were expected");
  const bool isInFrame = line.takeWord("pose_trans");
  if (isInFrame) {
    const auto frame = line.take("(") ? frames.find(line.name()) : frames.end();
    if (frame == frames.end() || !line.take(",")) return unread(call, number);
    motion.frame = frame->second;
    const std::string_view name = frame->first;
    motion.frameName = readName(name.substr(name.starts_with(kUrFramePrefix) ? kUrFramePrefix.size() : 0));
  }
  const bool isPose = line.take("p");
  const auto numbers = line.numbersWithin('[', ']', 6);
  if (!numbers || numbers->size() != 6) return line.malformed("target", "six numbers in brackets were expected");
  if (isInFrame && (!isPose || !line.take(")"))) return unread(call, number);
  const auto& n = *numbers;
  if (isPose) {
    motion.pose = urPoseOf(n);
  } else {
    motion.joints = Eigen::Map<const Eigen::VectorXd>(n.data(), 6);
  }
  const UrArguments arguments(line.rest());
  if (!arguments.isWhole() || callsOther(line.rest(), kUrFunctions)) return unread(call, number);
  const std::string_view zone = arguments.text("r", hasTime ? 4 : 3).value_or("0");
  const auto radius = numberAlone(zone);
  if (!radius || !(*radius >= 0.0)) return unread(zone, number);
  motion.blend = *radius / kMetresOfMillimetre;
  motion.speed = numberAlone(arguments.text("v", 2).value_or(""));
  const bool isByTime = hasTime && numberAlone(arguments.text("t", 3).value_or("0")) != 0.0;
  if (isByTime || !(motion.speed.value_or(0.0) > 0.0)) motion.speed = std::nullopt;
  return motion;
}

std::string urFunctionName(const RobotProgram& program) {
  return identifierBeside(kUrWords, program.name, 60);
}

// Returns true if lines lead to poses in the frame of the cell, which is then a variable of this name. A pose has to be
// in the controller's base, and ROS' base_link is turned by 180° against that.
bool isInUrFrame(const RobotProgram& program) {
  return program.isBaseOfController && !program.frameName.empty();
}
// Returns the name of the frame's variable, distinct from the function, which cannot be assigned.
std::string urFrameName(const RobotProgram& program) {
  const std::string name = std::string(kUrFramePrefix) + frameIdentifier(program, {}, 50);
  return lowerCase(name) == lowerCase(urFunctionName(program)) ? name + "_1" : name;
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
  text += ",a=" + fixedText(kRampsASecond * speed, 7) + ",v=" + fixedText(speed, 7);
  return text + ",r=" + fixedText(kMetresOfMillimetre * zoneOf(program, i), 6) + ")\n";
}

// Calls of the language that neither move the robot nor change the effect of others. Anything that is in no list is
// refused.
constexpr std::array kUrStill = {"set_payload",
                                 "set_target_payload",
                                 "set_gravity",
                                 "sleep",
                                 "sync",
                                 "textmsg",
                                 "popup",
                                 "stopj",
                                 "stopl",
                                 "set_digital_out",
                                 "set_standard_digital_out",
                                 "set_configurable_digital_out",
                                 "set_tool_digital_out",
                                 "set_analog_out",
                                 "set_standard_analog_out",
                                 "set_tool_voltage"};

class UrScriptReading {
 public:
  explicit UrScriptReading(const RobotProgram& program) : m_program(program), m_tool(program.tool) {}

  std::vector<ParsedMotion> motions;

  Status read(const ProgramStatement& statement) {
    LineReader line(statement.text, statement.line);
    if (line.takeWord("movej")) return readMotion(line, statement.line, ProgramMotion::Kind::Joint, true);
    if (line.takeWord("movel")) return readMotion(line, statement.line, ProgramMotion::Kind::Linear, true);
    if (line.takeWord("movep")) return readMotion(line, statement.line, ProgramMotion::Kind::Linear, false);
    if (line.takeWord("set_tcp")) return setTool(line);
    for (const char* const still : kUrStill) {
      if (!line.takeWord(still)) continue;
      return callsOther(line.rest(), kUrFunctions) ? Status(unread(statement.text, statement.line)) : Done{};
    }
    line.takeWord("global");
    line.takeWord("local");
    const std::string name(line.name());
    const bool isAssignment = !name.empty() && line.take("=") && !line.take("=");
    if (isAssignment) takeFrame(name, line);
    const bool isCalculation = isAssignment && !callsOther(line.rest(), kUrFunctions);
    return isCalculation ? Status(Done{}) : unread(statement.text, statement.line);
  }

 private:
  // Assigns a variable, which is a pose in numbers from now on, or something else.
  void takeFrame(const std::string& name, LineReader value) {
    const auto numbers = value.take("p") ? value.numbersWithin('[', ']', 6) : std::nullopt;
    value.skipSpace();
    m_frames.erase(name);
    if (numbers && numbers->size() == 6 && value.rest().empty()) m_frames[name] = urPoseOf(*numbers);
  }

  Status setTool(LineReader& line) {
    const auto numbers = line.take("(") && line.take("p") ? line.numbersWithin('[', ']', 6) : std::nullopt;
    if (!numbers || numbers->size() != 6) return line.malformed("tool", "six numbers in brackets were expected");
    m_tool = urPoseOf(*numbers);
    m_isToolSet = true;
    return Done{};
  }

  Status readMotion(LineReader& line, std::size_t number, ProgramMotion::Kind kind, bool hasTime) {
    if (motions.size() >= PostProcessor::kMostMotions) return line.malformed("movej", "there are too many motions");
    Result<ParsedMotion> motion = urTarget(line, number, kind, hasTime, m_frames);
    if (!motion) return motion.error();
    if (motion->speed && kind == ProgramMotion::Kind::Joint)
      motion->speed = std::min(1.0, *motion->speed / urFullSpeed(m_program));
    else if (motion->speed)
      *motion->speed /= kMetresOfMillimetre;
    if (motion->pose)
      motion->pose = poseInProgram(m_program, motion->frame.value_or(Pose(Pose::Identity())), *motion->pose, m_tool);
    if (m_isToolSet) motion->tool = m_tool;
    motion->isInControllersBase = motion->pose.has_value();
    motions.push_back(std::move(motion).value());
    return Done{};
  }

  const RobotProgram& m_program;
  Pose m_tool;  // in the flange: that of the cell until the program sets another
  bool m_isToolSet = false;
  UrFrames m_frames;
};

// Splits the program into functions. Blocks within them end like these do.
ProgramRoutines urRoutines(const std::vector<ProgramStatement>& statements) {
  ProgramRoutines routines;
  std::vector<bool> areBlocks;  // open statements
  for (const ProgramStatement& statement : statements) {
    LineReader line(statement.text, statement.line);
    if (line.takeWord("def")) {
      areBlocks.push_back(false);
      routines.begin(std::string(line.name()), statement.line);
    } else if (line.takeWord("end")) {
      if (!areBlocks.empty() && !areBlocks.back()) routines.end();
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
  text += "  # The load is that of the installation. An assumption was: set_payload(" +
          fixedText(std::max(0.001, program.toolMass), 3) + ")\n";
  if (isInUrFrame(program))
    text += "  " + urFrameName(program) + " = " + urPose(program.frame) + "\n";
  else if (!program.frameName.empty())
    text += "  # The frame " + identifierOf(program.frameName, 60) +
            " in the base of the robot's description, not used here: " + urPose(program.frame) + "\n";
  for (std::size_t i = 0; i < program.motions.size(); ++i) text += urMotion(program, i);
  return text + "end\n\n# Leave this call out where the file is sent to a port of the controller.\n" + name + "()\n";
}

// Poses of URScript are in the controller's base, which is treated here as the arm's, and in the program's frame.
Result<std::vector<ParsedMotion>> UrScriptPost::read(std::string_view text, const RobotProgram& frame) const {
  const Result<std::vector<std::string_view>> lines = programLines(text, "#");
  if (!lines) return lines.error();
  const auto unrolled = urRoutines(statementsOf(*lines)).unrolled({}, [](std::string_view statement) {
    LineReader line(statement, 0);
    const std::string name(line.name());
    const bool isCall = line.take("(") && line.take(")");
    line.skipSpace();
    return isCall && line.rest().empty() ? name : std::string();
  });
  if (!unrolled) return unrolled.error();
  UrScriptReading reading(frame);
  for (const ProgramStatement& each : *unrolled) {
    if (const Status read = reading.read(each); !read) return read.error();
  }
  return std::move(reading.motions);
}

}  // namespace handwheel
