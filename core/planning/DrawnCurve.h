// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PartSurface.h"

#include <memory>

namespace handwheel {

// A curve drawn on a part, as a chain of plane sections. From place to place it goes along the section with the plane
// through both places and the surface's normal there, the shorter way.
class DrawnCurve {
 public:
  // The curve begins at the place of the surface nearest to this one.
  DrawnCurve(std::shared_ptr<const PartSurface> surface, const Vec3& begin);

  // Goes on to the place of the surface nearest to this one. False, and nothing changed: no section leads there; it is
  // on another piece of the part, or straight through it. A place where the curve is already changes nothing.
  // As PartSurface::sectionNear().
  bool goOnTo(const Vec3& place);
  const SurfaceTrack& track() const { return m_track; }  // empty until it goes on

 private:
  std::shared_ptr<const PartSurface> m_surface;
  TrackPoint m_end;
  SurfaceTrack m_track;
};

}  // namespace handwheel
