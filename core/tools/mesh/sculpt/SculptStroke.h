// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/PatchLevels.h"
#include "mesh/sculpt/SculptBrush.h"
#include "mesh/search/FaceHierarchy.h"
#include "tools/mesh/sculpt/SculptSettings.h"

#include <memory>

namespace handwheel {

// A point on a face of a surface. The surface may have moved since its face hierarchy was built.
struct SurfacePosition {
  Face face;
  Vec3 point;
};
// Intersects a ray with a mesh, using the face hierarchy of an earlier version. The hit is searched within this radius
// (mm) of the present position of the point hit in the earlier version. Returns nothing if the ray does not hit the
// mesh.
std::optional<SurfacePosition> hitOn(const HalfEdgeMesh& mesh, const FaceHierarchy& sorted, const Ray& ray,
                                     double radius);

// One stroke of a brush over a surface, from press to release.
class SculptStroke {
 public:
  struct Settings {
    SculptSettings::Brush brush = SculptSettings::Brush::Drag;
    double radius = 0.0;    // mm
    double strength = 0.0;  // below 0: the brush acts inwards, or away from the plane
    bool movesBorder = false;
    std::size_t level = 0;
    NumberType numbers = NumberType::Float64;
  };
  // Begins a stroke at a position on the finest level. Vertices outside the patch do not move, unless the patch is
  // empty.
  SculptStroke(PatchLevels levels, const Settings& settings, const SurfacePosition& position, const Ray& ray);

  // Move the pointer: to a ray, or by the displacement of the tip of a haptic device (mm).
  void dragTo(const Ray& ray);
  void dragBy(const Vec3& displacement);
  // Applies one dab, for brushes other than Drag.
  void dab(const SurfacePosition& position);

  const Settings& settings() const { return m_settings; }
  const SurfacePosition& start() const { return m_start; }
  const PatchLevels& levels() const { return m_levels; }  // the present levels
  const FaceSelection& touched() const { return m_touched; }
  // The data for repeating the stroke: the positions of the dabs, or the final displacement of the brush Drag.
  const std::vector<SurfacePosition>& dabs() const { return m_dabs; }
  const Vec3& displacement() const { return m_displacement; }
  bool changedAnything() const { return !m_touched.empty(); }
  // Number of faces that the dabs covered, for callers that must limit the effort.
  std::size_t facesMet() const { return m_facesMet; }

 private:
  BrushArea areaAt(const SurfacePosition& position) const;
  void move(const std::vector<VertexGoal>& moves);

  const Settings m_settings;
  const PatchLevels m_before;
  PatchLevels m_levels;
  SurfacePosition m_start;
  Vec3 m_forward;
  BrushArea m_area;  // area of the brush Drag
  std::vector<SurfacePosition> m_dabs;
  Vec3 m_displacement = Vec3::Zero();
  FaceSelection m_touched;
  std::size_t m_facesMet = 0;
};

}  // namespace handwheel
