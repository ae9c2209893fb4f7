// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/FaceHierarchy.h"
#include "mesh/PatchLevels.h"
#include "mesh/SculptBrush.h"
#include "tools/mesh/SculptSettings.h"

#include <memory>

namespace handwheel {

// A place on a surface that may have been moved since its faces were sorted.
struct SurfacePlace {
  Face face;
  Vec3 point;
};
// What a ray meets of a mesh whose faces were sorted as they stood in an earlier version: within this radius (mm) of
// what has become of the place that it meets there. None where it meets nothing.
std::optional<SurfacePlace> placeOn(const HalfEdgeMesh& mesh, const FaceHierarchy& sorted, const Ray& ray,
                                    double radius);

// One stroke of a brush over a surface, from press to release.
class SculptStroke {
 public:
  struct Settings {
    SculptSettings::Brush brush = SculptSettings::Brush::Drag;
    double radius = 0.0;    // mm
    double strength = 0.0;  // below 0: inwards, away from the plane
    bool movesBorder = false;
    std::size_t level = 0;
    NumberType numbers = NumberType::Float64;
  };
  // Begins at a place of the finest level. Vertices outside the patch stay, unless the patch is empty.
  SculptStroke(PatchLevels levels, const Settings& settings, const SurfacePlace& place, const Ray& ray);

  // The pointer has moved. tip: of a haptic device, which was there at the beginning.
  void dragTo(const Ray& ray);
  void dragBy(const Vec3& way);
  // One dab; the brushes other than Drag.
  void dab(const SurfacePlace& place);

  const Settings& settings() const { return m_settings; }
  const SurfacePlace& start() const { return m_start; }
  const PatchLevels& levels() const { return m_levels; }  // as they are now
  const FaceSelection& touched() const { return m_touched; }
  // What it was made of, for who makes it once more: the places of the dabs; for Drag, the way in the end.
  const std::vector<SurfacePlace>& dabs() const { return m_dabs; }
  const Vec3& way() const { return m_way; }
  bool changedAnything() const { return !m_touched.empty(); }
  // Faces that dabs went over, for who must keep their number low.
  std::size_t facesMet() const { return m_facesMet; }

 private:
  BrushArea areaAt(const SurfacePlace& place) const;
  void move(const std::vector<VertexGoal>& moves);

  const Settings m_settings;
  const PatchLevels m_before;
  PatchLevels m_levels;
  SurfacePlace m_start;
  Vec3 m_forward;
  BrushArea m_area;  // of Drag
  std::vector<SurfacePlace> m_dabs;
  Vec3 m_way = Vec3::Zero();
  FaceSelection m_touched;
  std::size_t m_facesMet = 0;
};

}  // namespace handwheel
