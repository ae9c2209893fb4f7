// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PartSurface.h"

#include <memory>

namespace handwheel {

// A curve drawn on a part, as a chain of plane sections. Between two points it follows the section with the plane
// through both points and the surface normal there, in the shorter direction.
class DrawnCurve {
 public:
  // Begins the curve at the surface point nearest to this position.
  DrawnCurve(std::shared_ptr<const PartSurface> surface, const Vec3& begin);

  // Continues to the surface point nearest to this position. Returns false and changes nothing if no section leads
  // there: the point is on another piece of the part, or straight through it. A point that the curve is already at
  // changes nothing. Cost: as PartSurface::sectionNear().
  bool goOnTo(const Vec3& position);
  const SurfaceTrack& track() const { return m_track; }  // empty until goOnTo()

 private:
  std::shared_ptr<const PartSurface> m_surface;
  TrackPoint m_end;
  SurfaceTrack m_track;
};

}  // namespace handwheel
