// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "robot/RobotArms.h"

#include <map>
#include <set>
#include <string_view>

namespace handwheel {

// Two links, the one with the smaller number first.
using LinkPair = std::pair<std::uint32_t, std::uint32_t>;

// What a semantic description (SRDF) adds to a robot.
struct RobotSemantics {
  std::set<LinkPair> allowed;  // whose collisions do not count
  struct State {
    std::string name, group;
    std::map<std::uint32_t, double> values;  // by degree of freedom; rad, mm
  };
  std::vector<State> states;
  std::vector<Error> damage;  // what was left out, as it names links or joints that are not there; the first hundred
};

constexpr std::size_t kLargestSrdf = std::size_t{16} << 20;  // bytes that are read

// Reads an SRDF of this robot: disable_collisions, disable_default_collisions with enable_collisions, and group_state.
// O(bytes log links). Errors: ElementMalformed, FileTooLarge, Unsupported, OutOfMemory, Cancelled; with the line.
Result<RobotSemantics> readSrdf(std::string_view bytes, const RobotModel& robot, Progress progress = {});
// The same of one of the robots in a model: the file calls its links and joints as its own description does; those of
// the others, to allow pairs of two robots, as the model does.
Result<RobotSemantics> readSrdf(std::string_view bytes, const RobotModel& robot, std::span<const RobotArm> arms,
                                std::size_t arm, Progress progress = {});

// The pairs of links that a joint joins: these always touch. Links without a shape count as part of what they hang on.
std::set<LinkPair> neighbours(const RobotModel& robot);

}  // namespace handwheel
