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

// Two links, the one with the smaller index first.
using LinkPair = std::pair<std::uint32_t, std::uint32_t>;

// The semantic description (SRDF) of a robot.
struct RobotSemantics {
  std::set<LinkPair> allowed;  // pairs whose collisions are ignored
  struct State {
    std::string name, group;
    std::map<std::uint32_t, double> values;  // by degree of freedom; rad, mm
  };
  std::vector<State> states;
  std::vector<Error> damage;  // the first hundred parts that were omitted, for example because they name unknown links
};

constexpr std::size_t kLargestSrdf = std::size_t{16} << 20;  // limit of the size of a file, bytes

// Reads an SRDF of this robot: disable_collisions, disable_default_collisions with enable_collisions, and group_state.
// O(bytes log links). Errors, with the line: ElementMalformed, FileTooLarge, Unsupported, OutOfMemory, Cancelled.
Result<RobotSemantics> readSrdf(std::string_view bytes, const RobotModel& robot, Progress progress = {});
// Reads the SRDF of one of the robots in a model. Its own links and joints have the names of its description in the
// file. The links of other robots, for pairs of links of two robots, have the names of the model.
Result<RobotSemantics> readSrdf(std::string_view bytes, const RobotModel& robot, std::span<const RobotArm> arms,
                                std::size_t arm, Progress progress = {});

// Returns the pairs of links that a joint connects, which always touch. A link without a shape counts as part of its
// parent.
std::set<LinkPair> neighbours(const RobotModel& robot);

}  // namespace handwheel
