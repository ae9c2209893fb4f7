// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/Tool.h"

namespace handwheel {

// A drag over the horizontal plane through the point where it began. With Shift, or where that plane is seen from the
// side, along Z. In steps that fit the zoom, except with Ctrl. mm.
class FloorDrag {
 public:
  // grip: where it was grabbed; start: where its origin was then.
  FloorDrag(const Vec3& grip, const Vec3& start, const PointerEvent& press);

  // Where its origin comes to under the pointer; none: it stays. now: where it is; shownUnit: that steps are counted
  // in. Coordinates along which the drag does not go keep every bit.
  std::optional<Vec3> placeFor(const PointerEvent& event, const Vec3& now, double shownUnit);
  bool hasMoved() const { return m_hasMoved; }

 private:
  Vec3 m_grip, m_start;
  Ray m_ray;                  // at the press
  bool m_isFlatView = false;  // the horizontal plane is seen from the side
  bool m_isUpright = false;   // moves along Z
  bool m_hasMoved = false;
};

}  // namespace handwheel
