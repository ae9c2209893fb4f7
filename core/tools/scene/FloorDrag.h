// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/Tool.h"

namespace handwheel {

// A drag over the horizontal plane through the point where it began. With Shift, or if that plane is seen from the
// side, the drag is along Z. Unless Ctrl is held, it moves in steps that fit the zoom. All positions are in mm.
class FloorDrag {
 public:
  // grip: the grabbed point; start: the position of the object's origin at that time.
  FloorDrag(const Vec3& grip, const Vec3& start, const PointerEvent& press);

  // Returns the new position of the object's origin under the pointer, or nothing if the object stays. now: its present
  // position. shownUnit: mm per displayed unit; steps are round numbers in that unit. Coordinates in which the drag
  // does not move the object stay the same to the last bit.
  std::optional<Vec3> positionFor(const PointerEvent& event, const Vec3& now, double shownUnit);
  bool hasMoved() const { return m_hasMoved; }
  bool isUpright() const { return m_isUpright; }  // Returns true if the drag moves along Z

 private:
  Vec3 m_grip, m_start;
  Ray m_ray;                  // ray of the pointer when the button was pressed
  bool m_isFlatView = false;  // true if the horizontal plane is seen from the side
  bool m_isUpright = false;
  bool m_hasMoved = false;
};

}  // namespace handwheel
