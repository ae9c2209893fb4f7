// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/SeededInput.h"
#include "planning/Plan.h"

namespace handwheel {

// A cell to measure planning in: a built-in robot among boxes that stand around it.
class ArmAmongBoxes {
 public:
  // thickness: mm, of the boxes, which are 250 mm high and wide.
  ArmAmongBoxes(double thickness, std::uint64_t seed);

  const RobotScene& scene() const { return m_scene; }
  ArmValues anywhere(Random& random) const;      // within the limits
  ArmValues anywhereFree(Random& random) const;  // where nothing meets
  // To within a radian of there, in each joint.
  ArmValues near(const ArmValues& place, Random& random) const;

 private:
  static RobotScene made();

  RobotScene m_scene;
};

}  // namespace handwheel
