// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/snap/SnapField.h"
#include "haptics/snap/SnapProfile.h"
#include "haptics/snap/SnapResult.h"

namespace handwheel {

// Snap force by the proxy method, with one feature at a time. That feature holds the proxy, and the force pulls the tip
// to the proxy.
// - Among features of one dimension, the one closest to the proxy is held. Among equally close ones, as at the edge
//   that two triangles share, it is the one closest to the tip. So a held feature stays held until the tip is further
//   than the snap distance from it, and the proxy slides over a fan of triangles and along a curve.
// - Among different dimensions, a feature of the highest dimension is held first. When the proxy comes within the snap
//   distance of a feature of a lower dimension that is in reach of the tip, that feature is held: the proxy slides
//   along a line and snaps to its end.
//
// The held feature is identified by its position, so that it survives a new field after an edit. When it has
// disappeared, the servo loop ramps the discontinuity. The force may be discontinuous when the held feature changes.
//
// The class is used on the servo thread only, and does not allocate.
class SnapProxy {
 public:
  // Returns the pull on the device tip at `hand` (mm) in this tick. If the position is not finite, there is no pull,
  // and the held feature stays held.
  SnapResult step(const SnapField& field, const SnapProfile& profile, const Vec3& hand);

  // Releases the held feature. Must be called when snapping begins, and after the clutch was used.
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
