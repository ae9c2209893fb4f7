// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/SrdfReader.h"
#include "robot/dh/DhTable.h"
#include "robot/posts/PostProcessor.h"
#include "robot/program/PathFile.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is the file, which all
// readers get that a planner's files go through: programs, paths, semantic descriptions, tables.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "RobotTextFuzz: %s\n", what);
  std::abort();
}

void judgePrograms(std::string_view text, const RobotProgram& frame) {
  for (const auto& post : posts()) {
    const auto motions = post->read(text, frame);
    if (!motions) continue;
    require(motions->size() <= PostProcessor::kMostMotions, "too many motions");
    for (const ParsedMotion& motion : *motions) {
      require(motion.joints.has_value() != motion.pose.has_value(), "neither joints nor a pose, or both");
      if (motion.joints) require(motion.joints->size() == frame.arm.size(), "another number of joints");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const DhTable& table = *libraryTable("irb120");
  static const RobotModel kRobot = robotOf(table);
  static const RobotProgram kFrame = [&] {
    RobotProgram program;
    program.arm = armOf(std::vector<DhRow>(table.joints.begin(), table.joints.end()));
    return program;
  }();
  judgePrograms(text, kFrame);
  if (const auto path = readPath(text, kRobot, restValues(kRobot))) {
    for (const Waypoint& waypoint : path->waypoints)
      require(valuesWithinLimits(kRobot, waypoint.joints).hasValue(), "a place beyond the limits");
  }
  if (const auto semantics = readSrdf(text, kRobot)) {
    for (const auto& [a, b] : semantics->allowed)
      require(a < b && b < kRobot.links.size(), "a pair of links that are not there");
  }
  if (const auto read = readDhTable(text))
    require(read->joints.size() <= static_cast<std::size_t>(kMostArmJoints), "too many joints");
  return 0;
}
