// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/scene/ForceSource.h"

namespace handwheel {

// A spring and a damper that pull and turn the tip. Tools request springs (He 2008, sections 4.1.4 and 3.2). The torque
// is proportional to the full angle of the rotation (He 2008, eq. 3-16).
struct Spring {
  Vec3 target = Vec3::Zero();                                // mm
  double stiffness = 0.0;                                    // N/mm
  double damping = 0.0;                                      // N·s/mm
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  // the orientation to which the tip is turned
  double turning = 0.0;                                      // N·mm/rad
};

// The force and the torque of springs.
class SpringForce : public ForceSource {
 public:
  SpringForce(std::string id, std::vector<Spring> springs);

  ForceBounds advance(const TipState& tip, ForceOut& out) noexcept override;
  Vec3 force(const TipState& tip, double stiffness, double damping) noexcept override;
  Vec3 torque(const TipState& tip) noexcept override;
  bool isAttraction() const override { return true; }

 private:
  std::vector<Spring> m_springs;
  ForceBounds m_bounds;
};

}  // namespace handwheel
