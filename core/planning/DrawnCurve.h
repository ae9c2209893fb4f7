// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PartSurface.h"

#include <memory>

namespace handwheel {

// A curve drawn on a part, as a chain of plane sections. Between two points it follows a plane section of the surface,
// in the shorter direction. The plane contains both points and the mean of their surface normals.
class DrawnCurve {
 public:
  // Begins the curve at the surface point nearest to this position.
  DrawnCurve(std::shared_ptr<const PartSurface> surface, const Vec3& begin);

  // Continues the curve to the surface point nearest to this position. Returns false and changes nothing if no section
  // leads to this point, because it is on another piece of the part or on the opposite side. Returns true and changes
  // nothing if the curve already ends at this point. The cost is that of PartSurface::sectionNear().
  bool goOnTo(const Vec3& position);
  const SurfaceTrack& track() const { return m_track; }  // empty before the first successful goOnTo()

 private:
  std::shared_ptr<const PartSurface> m_surface;
  TrackPoint m_end;
  SurfaceTrack m_track;
};

}  // namespace handwheel
