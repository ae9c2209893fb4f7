// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/ClosedFormIk.h"

#include <array>
#include <optional>
#include <span>
#include <string>

namespace handwheel {

// The confdata of RAPID. They say in which way a robot with a spherical wrist reaches a pose.
struct RapidConfiguration {
  // cf1, cf4, cf6: the quarter turns that axes 1, 4 and 6 are in, 0 from 0 to 90 degrees, -1 from -90 to 0.
  std::array<int, 3> quarters{};
  // cfx. 4: the wrist is behind axis 1. 2: it is behind the lower arm. 1: axis 5 is below 0. The sum of what holds.
  int way = 0;

  std::string text() const;  // "[0,-1,1,2]"
  bool operator==(const RapidConfiguration&) const = default;
};

// Six revolute joints.
RapidConfiguration rapidConfigurationOf(const SerialArm& arm, const ArmValues& values);

// Whether joint values that were computed from a pose of a file are of this configuration, as far as its rounding lets
// one tell. Where the axes 4 and 6 are in line their quarter turns do not count.
bool hasConfiguration(const RapidConfiguration& wanted, const SerialArm& arm, const ArmValues& values);

// Of the four numbers of confdata. None: they name no way, as 9E9, which stands for what is not known, and parts of
// quarter turns.
std::optional<RapidConfiguration> rapidConfigurationFrom(std::span<const double> numbers);

// The joint values of this configuration, within the limits, that bring the tip of the arm there; the nearest to the
// reference where they leave a choice. None: there are none. closed: that of the arm, with a spherical wrist.
std::optional<ArmValues> jointsWith(const RapidConfiguration& wanted, const SerialArm& arm, const ClosedFormIk& closed,
                                    const Pose& tip, const ArmValues& reference);

}  // namespace handwheel
