// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/SeededInput.h"
#include "planning/Plan.h"

namespace handwheel {

// A cell for measuring motion planning: a built-in robot with boxes around it.
class ArmAmongBoxes {
 public:
  // thickness: the thickness of the boxes, mm. The boxes are 250 mm high and wide.
  ArmAmongBoxes(double thickness, std::uint64_t seed);

  const RobotScene& scene() const { return m_scene; }
  ArmValues anywhere(Random& random) const;      // random configuration within the joint limits
  ArmValues anywhereFree(Random& random) const;  // random configuration without collisions
  // Returns random values within a radian of the given ones, in each joint.
  ArmValues near(const ArmValues& middle, Random& random) const;

 private:
  static RobotScene made();

  RobotScene m_scene;
};

}  // namespace handwheel
