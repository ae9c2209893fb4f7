// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/SnapField.h"
#include "haptics/SnapProfile.h"
#include "haptics/SnapPull.h"

namespace handwheel {

// The proxy method: one feature at a time holds the proxy, and the force draws the hand to it.
// - Of features of one dimension the one closest to the proxy; of those equally close, as at the edge that two
//   triangles share, the one closest to the hand. So what is held stays held until the hand is further than the snap
//   distance from it, and the proxy slides over a fan of triangles and along a curve.
// - Of different dimensions first the highest; when the proxy comes within the snap distance of a lower one that is in
//   reach of the hand, that: slide along a line, snap to its end.
// What is held is known by its place, so it survives a new field after an edit; the servo loop ramps the leap when it
// is gone. Going from one feature to another may leap.
//
// For one thread, the servo's; no allocation.
class SnapProxy {
 public:
  // What it does to a hand (mm) at this tick. For a hand that is not finite nothing, and what is held stays held.
  SnapPull step(const SnapField& field, const SnapProfile& profile, const Vec3& hand);

  // Lets go: when snapping begins, or the hand was moved without moving (the clutch).
  void release() { m_isHeld = false; }
  bool isHeld() const { return m_isHeld; }
  SnapFeature held() const { return m_held; }

 private:
  using Hold = SnapLayer::Hold;

  Hold capture(const SnapField& field, const SnapLayer::Reach& reach);
  Hold slide(const SnapLayer& layer, SnapLayer::Reach reach, Hold hold) const;
  Hold descend(const SnapField& field, SnapLayer::Reach reach, Hold hold);

  bool m_isHeld = false;
  std::size_t m_dimension = 0;
  SnapFeature m_held;
  Vec3 m_proxy = Vec3::Zero();  // mm, in the scene
};

}  // namespace handwheel
