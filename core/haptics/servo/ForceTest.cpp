// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo/ForceTest.h"

#include <cmath>

namespace handwheel {

// The inverse of deviceForce(): rotations and reflections, whose inverse is their transpose, and the gain.
ForceTest::ForceTest(double force, const WorkspaceMapping& mapping)
    : m_sceneFromDevice(mapping.sceneFromView.linear() * mapping.viewFromDevice() / mapping.forceGain),
      m_force(force) {}

void ForceTest::tick(const TipState& tip, ForceOut& out) noexcept {
  if (!m_hasBegun) m_begin = tip.time;
  m_hasBegun = true;
  const double pulls = (tip.time - m_begin) / kPullTime;
  if (!(pulls >= 0.0 && pulls < 6.0)) return;
  const int pull = static_cast<int>(pulls);
  const double sign = pull % 2 == 0 ? 1.0 : -1.0;
  out.force = m_sceneFromDevice.col(pull / 2) * (sign * m_force * std::sin(M_PI * (pulls - pull)));
}

}  // namespace handwheel
