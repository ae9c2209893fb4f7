// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

#include <optional>
#include <string>

namespace handwheel {

class ClosedFormIk;

// S and T of KRL: in which way a robot reaches a pose.
struct KrlStatus {
  // Bit 0: the wrist is behind axis 1 (overhead). Bit 1: axis 3 is beyond where the wrist is in line with the lower
  // arm. Bit 2: axis 5 is below 0.
  std::optional<unsigned> status = {};
  std::optional<unsigned> turn = {};  // bit i - 1: axis i is below 0

  std::string text() const;  // "S 'B010',T 'B000010'"
};

// Six revolute joints.
KrlStatus krlStatusOf(const SerialArm& arm, const ArmValues& values);

// The joint values with these S and T, within the limits, that bring the tip of the arm there; the nearest to the
// reference where they leave a choice. None: there are none. closed: that of the arm.
std::optional<ArmValues> jointsWith(const KrlStatus& wanted, const SerialArm& arm, const ClosedFormIk& closed,
                                    const Pose& tip, const ArmValues& reference);

}  // namespace handwheel
