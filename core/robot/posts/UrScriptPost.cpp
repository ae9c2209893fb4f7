// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/PostText.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kMetresOfMillimetre = 1e-3;

// X, Y, Z in metres and a turn as an axis of its angle's length.
std::string urPose(const Pose& pose) {
  const Vec3 at = kMetresOfMillimetre * pose.translation();
  const Eigen::AngleAxisd turn(pose.linear());
  const Vec3 way = turn.angle() * turn.axis();
  const double numbers[] = {at.x(), at.y(), at.z(), way.x(), way.y(), way.z()};
  return "p[" + fixedList(numbers, 9) + "]";
}

// rad/s of the fastest joint; hinges without a known velocity turn 180° a second.
double urSpeed(const RobotProgram& program, const ProgramMotion& motion) {
  double fastest = M_PI;
  for (const ArmJoint& joint : program.arm.joints()) fastest = std::min(fastest, joint.velocity.value_or(M_PI));
  return fastest * std::clamp(motion.speed, 0.001, 1.0);
}

// Zones of neighbours must not overlap, and the last motion has none; mm.
double zoneOf(const RobotProgram& program, std::size_t i) {
  if (i == 0 || i + 1 >= program.motions.size()) return 0.0;
  const auto at = [&](std::size_t k) { return Vec3(program.tipOf(program.motions[k]).translation()); };
  const double near = std::min((at(i) - at(i - 1)).norm(), (at(i + 1) - at(i)).norm());
  return std::min(program.motions[i].blend, 0.49 * near);
}

Result<ReadMotion> urTarget(LineReader& line, std::size_t number, ProgramMotion::Kind kind) {
  ReadMotion motion{kind, {}, {}, 0.0, number};
  if (!line.take("(")) return line.malformed("target", "numbers in brackets were expected");
  const bool isPose = line.take("p");
  const auto numbers = line.numbersWithin('[', ']', 6);
  if (!numbers || numbers->size() != 6) return line.malformed("target", "six numbers in brackets were expected");
  const auto& n = *numbers;
  if (isPose) {
    const Vec3 turn(n[3], n[4], n[5]);
    Pose pose(Eigen::Translation3d(Vec3(n[0], n[1], n[2]) / kMetresOfMillimetre));
    if (turn.norm() > 0.0) pose.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    motion.pose = pose;
  } else {
    motion.joints = Eigen::Map<const Eigen::VectorXd>(n.data(), 6);
  }
  const std::size_t zone = line.rest().find("r=");
  if (zone != std::string_view::npos)
    motion.blend = LineReader(line.rest().substr(zone + 2), 0).number().value_or(0.0) / kMetresOfMillimetre;
  return motion;
}

}  // namespace

std::string UrScriptPost::write(const RobotProgram& program) const {
  std::string text = "# " + identifierOf(program.robot, 60) + "\ndef " + identifierOf(program.name, 60) +
                     "():\n  set_tcp(" + urPose(program.tool) + ")\n";
  for (std::size_t i = 0; i < program.motions.size(); ++i) {
    const ProgramMotion& motion = program.motions[i];
    const std::string zone = ",r=" + fixedText(kMetresOfMillimetre * zoneOf(program, i), 6) + ")\n";
    if (motion.kind == ProgramMotion::Kind::Joint) {
      const double speed = urSpeed(program, motion);
      text += "  movej([" + fixedList(std::span(motion.joints.data(), 6), 9) + "],a=" + fixedText(4.0 * speed, 4) +
              ",v=" + fixedText(speed, 5) + zone;
    } else {
      text += "  movel(" + urPose(program.tipOf(motion)) +
              ",a=" + fixedText(4.0 * kMetresOfMillimetre * motion.speed, 4) +
              ",v=" + fixedText(kMetresOfMillimetre * motion.speed, 5) + zone;
    }
  }
  return text + "end\n";
}

// Poses of URScript are in the base: they are brought into the frame of the program.
Result<std::vector<ReadMotion>> UrScriptPost::read(std::string_view text, const RobotProgram& frame) const {
  const Result<std::vector<std::string_view>> lines = programLines(text, "#");
  if (!lines) return lines.error();
  std::vector<ReadMotion> motions;
  for (std::size_t i = 0; i < lines->size(); ++i) {
    LineReader line((*lines)[i], i + 1);
    const bool isJoint = line.takeWord("movej"),
               isLinear = !isJoint && (line.takeWord("movel") || line.takeWord("movep"));
    for (const char* const other : {"movec", "servoj", "servoc", "speedj", "speedl"}) {
      if (line.takeWord(other)) return Error{ErrorCode::Unsupported, {other}, InputPosition::line(i + 1), {}};
    }
    if (!isJoint && !isLinear) continue;
    if (motions.size() >= kMostMotions) return line.malformed("movej", "there are too many motions");
    Result<ReadMotion> motion =
        urTarget(line, i + 1, isJoint ? ProgramMotion::Kind::Joint : ProgramMotion::Kind::Linear);
    if (!motion) return motion.error();
    if (motion->pose) motion->pose = frame.frame.inverse(Eigen::Isometry) * *motion->pose;
    motions.push_back(std::move(motion).value());
  }
  return motions;
}

}  // namespace handwheel
