// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "example/ExamplePost.h"

#include "robot/posts/PostText.h"

#include <algorithm>

namespace handwheel {

namespace {

// Poses are written in the frame of the program, with a quaternion that has length 1 and its real part first.
std::string poseText(const Pose& pose) {
  const Vec3 at = pose.translation();
  const Eigen::Quaterniond turn = Eigen::Quaterniond(pose.linear()).normalized();
  std::string text;
  for (const double value : {at.x(), at.y(), at.z()}) text += " " + fixedText(value, 6);
  for (const double value : {turn.w(), turn.x(), turn.y(), turn.z()}) text += " " + fixedText(value, 9);
  return text;
}

// Reads so many numbers separated by spaces; fewer at the end of the line.
std::vector<double> numbersOf(LineReader& line, std::size_t most) {
  std::vector<double> numbers;
  while (numbers.size() < most) {
    line.skipSpace();
    const auto number = line.number();
    if (!number) break;
    numbers.push_back(*number);
  }
  return numbers;
}

// Returns the number after a word in the rest of the line.
std::optional<double> wordValue(const LineReader& line, std::string_view word) {
  const std::size_t at = line.rest().find(word);
  return at == std::string_view::npos ? std::nullopt : LineReader(line.rest().substr(at + word.size()), 0).number();
}

Result<ParsedMotion> jointMotion(LineReader& line, std::size_t joints) {
  const std::vector<double> degrees = numbersOf(line, joints);
  if (degrees.size() != joints) return line.malformed("JOINT", "a number for each joint was expected");
  return ParsedMotion{.kind = ProgramMotion::Kind::Joint, .joints = radiansOf(degrees)};
}

Result<ParsedMotion> lineMotion(LineReader& line) {
  const std::vector<double> n = numbersOf(line, 7);
  const bool isPose = n.size() == 7 && Eigen::Vector4d(n[3], n[4], n[5], n[6]).norm() > 0.5;
  if (!isPose) return line.malformed("LINE", "a place and a quaternion were expected");
  Pose pose(Eigen::Translation3d(n[0], n[1], n[2]));
  pose.linear() = Eigen::Quaterniond(n[3], n[4], n[5], n[6]).normalized().toRotationMatrix();
  return ParsedMotion{.kind = ProgramMotion::Kind::Linear, .pose = pose};
}

}  // namespace

std::string ExamplePost::write(const RobotProgram& program) const {
  constexpr std::size_t kLongestName = 32;
  std::string text = "PROGRAM " + identifierOf(program.name, kLongestName) + "\n";
  for (const std::string& remark : headRemarks(program)) text += "; " + remark + "\n";
  for (const ProgramMotion& motion : program.motions) {
    if (motion.kind == ProgramMotion::Kind::Joint) {
      text += "JOINT";
      for (const double degrees : degreesOf(motion.joints)) text += " " + fixedText(degrees, 9);
      text += " SPEED " + fixedText(100.0 * motion.speed, 2);  // percent
    } else {
      text += "LINE" + poseText(program.frame.inverse(Eigen::Isometry) * program.tipOf(motion));
      text += " SPEED " + fixedText(motion.speed, 2);  // mm/s
    }
    text += " ZONE " + fixedText(motion.blend, 3) + "\n";
  }
  return text + "END\n";
}

Result<std::vector<ParsedMotion>> ExamplePost::read(std::string_view text, const RobotProgram& frame) const {
  const Result<std::vector<std::string_view>> lines = programLines(text, ";");
  if (!lines) return lines.error();
  std::vector<ParsedMotion> motions;
  for (std::size_t i = 0; i < lines->size(); ++i) {
    LineReader line((*lines)[i], i + 1);
    line.skipSpace();
    if (line.rest().empty() || line.takeWord("PROGRAM")) continue;
    if (line.takeWord("END")) break;
    if (motions.size() >= kMostMotions) return line.malformed("motion", "there are too many motions");
    const bool isJoint = line.takeWord("JOINT");
    // A statement that may move the robot and is not understood is an error, never left out.
    if (!isJoint && !line.takeWord("LINE")) return line.malformed("motion", "JOINT or LINE was expected");
    Result<ParsedMotion> motion =
        isJoint ? jointMotion(line, static_cast<std::size_t>(frame.arm.size())) : lineMotion(line);
    if (!motion) return motion.error();
    motion->blend = wordValue(line, "ZONE").value_or(0.0);
    if (const auto speed = wordValue(line, "SPEED"); speed && *speed > 0.0)
      motion->speed = isJoint ? std::min(1.0, 0.01 * *speed) : *speed;
    motion->line = i + 1;
    motions.push_back(*motion);
  }
  return motions;
}

}  // namespace handwheel
