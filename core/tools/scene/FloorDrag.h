// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/Tool.h"

namespace handwheel {

// A drag over the horizontal plane through the point where it began. With Shift, or if that plane is seen from the
// side, along Z. In steps that fit the zoom, except with Ctrl. mm.
class FloorDrag {
 public:
  // grip: the grabbed point; start: the position of the object's origin at that time.
  FloorDrag(const Vec3& grip, const Vec3& start, const PointerEvent& press);

  // Returns the new position of the object's origin under the pointer; nothing if it stays. now: its present position;
  // shownUnit: the unit of the steps. Coordinates across the drag keep every bit.
  std::optional<Vec3> positionFor(const PointerEvent& event, const Vec3& now, double shownUnit);
  bool hasMoved() const { return m_hasMoved; }

 private:
  Vec3 m_grip, m_start;
  Ray m_ray;                  // At the press
  bool m_isFlatView = false;  // True if the horizontal plane is seen from the side
  bool m_isUpright = false;   // True if the drag moves along Z
  bool m_hasMoved = false;
};

}  // namespace handwheel
