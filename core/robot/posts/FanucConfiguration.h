// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/ClosedFormIk.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// CONFIG of Fanuc programs. It says in which way a robot with a spherical wrist reaches a pose.
struct FanucConfiguration {
  bool isFlipped = false;      // F, else N: axis 5 is below 0
  bool isUp = true;            // U, else D: the elbow
  bool isBack = false;         // B, else T: the wrist is behind axis 1
  std::array<int, 3> turns{};  // whole turns of the axes 1, 4 and 6: 0 from -180 to 180 degrees

  std::string text() const;  // "N U T, 0, 0, 0"
};

// Six revolute joints.
FanucConfiguration fanucConfigurationOf(const SerialArm& arm, const ArmValues& values);

// Of a place with "CONFIG : 'N U T, 0, 0, 0'". None: it has no such text, or another one.
std::optional<FanucConfiguration> fanucConfigurationFrom(std::string_view place);

// The joint values of this configuration, within the limits, that bring the tip of the arm there; the nearest to the
// reference where they leave a choice. None: there are none. closed: that of the arm, with a spherical wrist.
std::optional<ArmValues> jointsWith(const FanucConfiguration& wanted, const SerialArm& arm, const ClosedFormIk& closed,
                                    const Pose& tip, const ArmValues& reference);

}  // namespace handwheel
