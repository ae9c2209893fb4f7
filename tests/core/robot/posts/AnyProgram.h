// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../Robots.h"
#include "robot/dh/DhTable.h"
#include "robot/posts/PostProcessor.h"

#include <cmath>

// Programs of arbitrary motions, for tests of the properties of posts.
namespace handwheel::test {

inline SerialArm armCalled(const char* id) {
  const DhTable& table = *libraryTable(id);
  return armOf(std::vector<DhRow>(table.joints.begin(), table.joints.end()))
      .withCoupling(libraryRobot(table.name)->coupling);
}

inline RobotProgram programOf(const char* id) {
  RobotProgram program;
  program.name = "weld seam 1";
  program.robot = id;
  program.arm = armCalled(id);
  program.tool = Pose(Eigen::Translation3d(10.0, -5.0, 120.0) * Eigen::AngleAxisd(0.3, Vec3::UnitY()));
  program.frame = Pose(Eigen::Translation3d(400.0, 50.0, -10.0) * Eigen::AngleAxisd(0.7, Vec3::UnitZ()));
  return program;
}

using ReadMotions = Result<std::vector<ParsedMotion>>;

inline ReadMotions readBy(const char* post, const std::string& text,
                          const RobotProgram& program = programOf("irb120")) {
  return postCalled(post)->read(text, program);
}

// Returns the line for which a program is refused; 0: it is read.
inline std::uint64_t refusedLine(const ReadMotions& read) {
  return read ? 0 : read.error().position.value;
}

// Returns what a post writes for the motions that were read, with their lines.
inline RobotProgram programWith(const std::vector<ParsedMotion>& motions, const char* language) {
  RobotProgram program = programOf("irb120");
  program.language = language;
  program.head = motions.front().before;
  for (const ParsedMotion& each : motions) {
    ProgramMotion motion{.joints = each.joints.value_or(ArmValues::Zero(6)), .name = each.name};
    motion.corner = each.corner;
    motion.seconds = each.seconds;
    motion.lines = each.lines;
    program.motions.push_back(motion);
  }
  return program;
}

// Returns any joint values within the limits, also those of a coupled axis, and of at most this size.
inline ArmValues anyJointsOf(const SerialArm& arm, double largest = HUGE_VAL) {
  ArmValues joints(arm.size());
  for (Eigen::Index i = 0; i < arm.size(); ++i) {
    const ArmJoint& joint = arm.joints()[static_cast<std::size_t>(i)];
    joints[i] = anyNumber(std::max(joint.lower, -largest), std::min(joint.upper, largest));
  }
  if (arm.coupling()) {
    const double shift = arm.coupling()->factor * joints[1];
    const ArmJoint& third = arm.joints()[2];
    joints[2] = anyNumber(std::max(third.lower, arm.coupling()->lower - shift),
                          std::min(third.upper, arm.coupling()->upper - shift));
  }
  return joints;
}

inline ProgramMotion anyMotion(const SerialArm& arm) {
  ProgramMotion motion;
  motion.joints = anyJointsOf(arm, M_PI);
  motion.kind = *rc::gen::arbitrary<bool>() ? ProgramMotion::Kind::Joint : ProgramMotion::Kind::Linear;
  motion.speed = motion.kind == ProgramMotion::Kind::Joint ? anyNumber(0.01, 1.0) : anyNumber(1.0, 2000.0);
  motion.blend = *rc::gen::arbitrary<bool>() ? anyNumber(0.5, 20.0) : 0.0;
  motion.name = *rc::gen::element<std::string>("", "", "start", "Move here 2", "\xe8\xb5\xb7\xe7\x82\xb9; END");
  return motion;
}

// Returns true if a motion was read back as it was written. Speeds may differ by half a step of the coarsest language
// (whole percent, tenths of mm/s), and a blend may be smaller than the wanted one.
inline bool isDoneAs(const ProgramMotion& wanted, const ParsedMotion& read) {
  const double step = wanted.kind == ProgramMotion::Kind::Joint ? 0.01 : 0.1;
  return read.kind == wanted.kind && read.speed && std::abs(*read.speed - wanted.speed) <= 0.501 * step &&
         read.blend >= 0.0 && read.blend <= wanted.blend + 1e-3;
}

// Checks that any program that a post writes for this robot is read back with the same motions and speeds.
inline void checkAnyProgram(const PostProcessor& post, const char* robot) {
  RobotProgram program = programOf(robot);
  program.isBaseOfController = *rc::gen::arbitrary<bool>();
  program.hasPlainShapes = *rc::gen::arbitrary<bool>();
  program.frameName = *rc::gen::element<std::string>("", "fixture 1", "\xe5\xa4\xb9\xe5\x85\xb7; END");
  program.name = *rc::gen::element<std::string>("weld seam 1", "Move", "test", "a name that is longer than any takes");
  for (int i = *rc::gen::inRange(0, 8); i >= 0; --i) program.motions.push_back(anyMotion(program.arm));
  RC_ASSERT(post.refusals(program).empty());
  const std::string text = post.write(program);
  const auto read = post.read(text, program);
  RC_ASSERT(read.hasValue());
  RC_ASSERT(read->size() == program.motions.size());
  for (std::size_t i = 0; i < read->size(); ++i) RC_ASSERT(isDoneAs(program.motions[i], (*read)[i]));
  const auto check = checkWritten(post, program, text);
  RC_ASSERT(check.hasValue());
  RC_ASSERT(check->distance <= 1e-3);
  RC_ASSERT(check->angle <= 1e-3);
  RC_ASSERT(check->motions == program.motions.size());
}

}  // namespace handwheel::test
