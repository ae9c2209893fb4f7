// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/ClosedFormIk.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// The CONFIG of Fanuc programs. A configuration distinguishes the solutions of a robot with a spherical wrist for a
// pose.
struct FanucConfiguration {
  bool isFlipped = false;      // F, otherwise N; N: axis 5 is below 0, or 0
  bool isUp = true;            // U, otherwise D; U: the wrist is ahead of the line from the second to the third axis
  bool isBack = false;         // B, otherwise T; B: the wrist is behind axis 1
  std::array<int, 3> turns{};  // whole turns of the axes 1, 4 and 6; 0: from -180 to 180 degrees

  std::string text() const;  // "N U T, 0, 0, 0"
};

// Returns the configuration of an arm of six revolute joints.
FanucConfiguration fanucConfigurationOf(const SerialArm& arm, const ArmValues& values);

// Parses the CONFIG of a position: "CONFIG : 'N U T, 0, 0, 0'". Returns nothing if the text is missing or has another
// form.
std::optional<FanucConfiguration> fanucConfigurationFrom(std::string_view position);

// Finds the joint values of this configuration, within the limits, for a pose of the arm's tip. If there are several
// solutions, the one nearest to the reference is returned; nothing if there is none. closed: the closed form of the
// arm, whose wrist must be spherical.
std::optional<ArmValues> jointsWith(const FanucConfiguration& wanted, const SerialArm& arm, const ClosedFormIk& closed,
                                    const Pose& tip, const ArmValues& reference);

}  // namespace handwheel
