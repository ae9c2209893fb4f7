// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/scene/ForceSource.h"

namespace handwheel {

// A spring and damper between the tip and a point. A tool requests it (He 2008, section 4.1.4).
struct Spring {
  Vec3 target = Vec3::Zero();  // mm
  double stiffness = 0.0;      // N/mm
  double damping = 0.0;        // N·s/mm
};

// The force of springs.
class SpringForce : public ForceSource {
 public:
  SpringForce(std::string id, std::vector<Spring> springs);

  ForceBounds advance(const TipState& tip, ForceOut& out) noexcept override;
  Vec3 force(const TipState& tip, double stiffness, double damping) noexcept override;
  bool isAttraction() const override { return true; }

 private:
  std::vector<Spring> m_springs;
  ForceBounds m_bounds;
};

}  // namespace handwheel
