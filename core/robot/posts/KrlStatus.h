// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

class ClosedFormIk;

// The values S and T of KRL. They distinguish the solutions of a robot for a pose.
struct KrlStatus {
  // Bit 0: the wrist is behind axis 1 (overhead). Bit 1: axis 3 is beyond the alignment of the wrist with the lower
  // arm. Bit 2: axis 5 is below 0.
  std::optional<unsigned> status = {};
  std::optional<unsigned> turn = {};  // bit i - 1: axis i is below 0

  std::string text() const;  // "S 'B010',T 'B000010'"
};

// The comment with the name of the frame that $BASE is set to.
inline constexpr std::string_view kKrlBaseName = "; $BASE is the frame ";

// Returns the status of an arm of six revolute joints.
KrlStatus krlStatusOf(const SerialArm& arm, const ArmValues& values);

// Finds the joint values with these S and T, within the limits, for a pose of the arm's tip. If there are several
// solutions, the one nearest to the reference is returned; nothing if there is none. closed: the closed form of the
// arm.
std::optional<ArmValues> jointsWith(const KrlStatus& wanted, const SerialArm& arm, const ClosedFormIk& closed,
                                    const Pose& tip, const ArmValues& reference);

}  // namespace handwheel
