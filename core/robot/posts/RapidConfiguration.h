// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/ClosedFormIk.h"

#include <array>
#include <optional>
#include <span>
#include <string>

namespace handwheel {

// The confdata of RAPID. A configuration distinguishes the solutions of a robot with a spherical wrist for a pose.
struct RapidConfiguration {
  // The values cf1, cf4 and cf6: the quarter turns of the axes 1, 4 and 6. 0: from 0 to 90 degrees; -1: from -90 to 0.
  std::array<int, 3> quarters{};
  // The value cfx, a sum. 4: the wrist is behind axis 1. 2: the wrist is behind the lower arm. 1: axis 5 is below 0.
  // Controllers of parallel linkages do not use it, as these cannot bend backwards: it is 0, and the wrist is never
  // behind the lower arm.
  int cfx = 0;

  std::string text() const;  // "[0,-1,1,2]"
  bool operator==(const RapidConfiguration&) const = default;
};

// Returns the configuration of an arm of six revolute joints.
RapidConfiguration rapidConfigurationOf(const SerialArm& arm, const ArmValues& values);

// Returns true if joint values that were computed from a pose of a file have this configuration, within the rounding of
// files. If the axes 4 and 6 are in line their quarter turns are ignored.
bool hasConfiguration(const RapidConfiguration& wanted, const SerialArm& arm, const ArmValues& values);

// Parses the four numbers of confdata. Returns nothing if they define no configuration, because one is a fraction of a
// quarter turn, or is 9E9, which denotes an unknown value.
std::optional<RapidConfiguration> rapidConfigurationFrom(std::span<const double> numbers);

// Finds the joint values of this configuration, within the limits, for a pose of the arm's tip. If there are several
// solutions, the one nearest to the reference is returned; nothing if there is none. closed: the closed form of the
// arm, whose wrist must be spherical.
std::optional<ArmValues> jointsWith(const RapidConfiguration& wanted, const SerialArm& arm, const ClosedFormIk& closed,
                                    const Pose& tip, const ArmValues& reference);

}  // namespace handwheel
