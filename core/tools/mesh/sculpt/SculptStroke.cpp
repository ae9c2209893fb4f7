// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/sculpt/SculptStroke.h"

#include "proximity/ClosestPoint.h"

#include <cmath>
#include <limits>

namespace handwheel {
namespace {

// The effect of a dab at full strength.
constexpr double kInflation = 0.1;   // fraction of the radius
constexpr double kFlattening = 0.5;  // fraction of the distance to the plane
// Rays that run more nearly along the plane in which a surface is dragged say nothing.
constexpr double kLeastSlope = 0.02;

// Returns the new position of a point on a triangle whose corners have moved.
Vec3 carried(const Vec3& p, const TrianglePoints& from, const TrianglePoints& to) {
  const Vec3 u = from[1] - from[0], v = from[2] - from[0], w = p - from[0];
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0.0)) return (to[0] + to[1] + to[2]) / 3.0;
  const double s = (vv * u.dot(w) - uv * v.dot(w)) / determinant, t = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
  return to[0] + s * (to[1] - to[0]) + t * (to[2] - to[0]);
}

// Returns the intersection as a multiple of the ray's direction (Möller and Trumbore, "Fast, minimum storage
// ray/triangle intersection", 1997); from either side.
std::optional<double> meeting(const Ray& ray, const TrianglePoints& t) {
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], off = ray.origin - t[0];
  const Vec3 across = ray.direction.cross(v), along = off.cross(u);
  const double determinant = u.dot(across);
  const double a = off.dot(across) / determinant, b = ray.direction.dot(along) / determinant;
  const double distance = v.dot(along) / determinant;
  if (!(a >= 0.0 && b >= 0.0 && a + b <= 1.0 && distance >= 0.0)) return std::nullopt;
  return distance;
}

}  // namespace

std::optional<SurfacePosition> hitOn(const HalfEdgeMesh& mesh, const FaceHierarchy& sorted, const Ray& ray,
                                     double radius) {
  const auto hit = ray.isUsable() ? sorted.firstHit(ray) : std::nullopt;
  if (!hit || hit->face >= mesh.faceSlots() || !mesh.isProper(hit->face)) return std::nullopt;
  const TrianglePoints then = sorted.mesh().points(hit->face), now = mesh.points(hit->face);
  if (then == now) return SurfacePosition{hit->face, hit->point};
  SurfacePosition position{hit->face, carried(hit->point, then, now)};
  double nearest = std::numeric_limits<double>::infinity();
  for (const Face f : brushArea(mesh, position.face, position.point, radius).faces) {
    const auto distance = meeting(ray, mesh.points(f));
    if (!distance || *distance >= nearest) continue;
    nearest = *distance;
    position = {f, ray.origin + nearest * ray.direction};
  }
  return position;
}

SculptStroke::SculptStroke(PatchLevels levels, const Settings& settings, const SurfacePosition& position,
                           const Ray& ray)
    : m_settings(settings),
      m_before(std::move(levels)),
      m_levels(m_before),
      m_start(position),
      m_forward(ray.direction.stableNormalized()) {
  if (settings.brush == SculptSettings::Brush::Drag) m_area = areaAt(position);
}

// The brush works on the chosen level, around its nearest point.
BrushArea SculptStroke::areaAt(const SurfacePosition& position) const {
  const HalfEdgeMesh& mesh = m_levels.mesh(m_settings.level);
  const Face face = m_levels.faceAt(m_settings.level, position.face);
  const auto [p, q, r] = mesh.points(face);
  const bool isFinest = m_settings.level == m_levels.finest();
  const Vec3 centre = isFinest ? position.point : closestOnTriangle(position.point, p, q, r);
  const FaceSelection& patch = m_levels.patch(m_settings.level);
  return brushArea(mesh, face, centre, m_settings.radius, {patch.empty() ? nullptr : &patch, m_settings.movesBorder});
}

void SculptStroke::dragTo(const Ray& ray) {
  const double slope = ray.direction.dot(m_forward);
  if (!ray.isUsable() || !(slope > kLeastSlope)) return;
  const Vec3 off = m_start.point - ray.origin;
  dragBy(off.dot(m_forward) / slope * ray.direction - off);
}

void SculptStroke::dragBy(const Vec3& displacement) {
  m_displacement = displacement;
  m_levels = m_before;
  move(dragged(m_levels.mesh(m_settings.level), m_area, displacement));
}

void SculptStroke::dab(const SurfacePosition& position) {
  m_dabs.push_back(position);
  const HalfEdgeMesh& mesh = m_levels.mesh(m_settings.level);
  const BrushArea area = areaAt(position);
  m_facesMet += area.faces.size();
  switch (m_settings.brush) {
    case SculptSettings::Brush::Smooth:
      return move(smoothed(mesh, area, std::abs(m_settings.strength)));
    case SculptSettings::Brush::Inflate:
      return move(inflated(mesh, area, kInflation * m_settings.strength * m_settings.radius));
    case SculptSettings::Brush::Flatten:
      return move(flattened(mesh, area, kFlattening * m_settings.strength));
    case SculptSettings::Brush::Drag:
      break;
  }
}

void SculptStroke::move(const std::vector<VertexGoal>& moves) {
  HalfEdgeMesh mesh = m_levels.mesh(m_settings.level);
  std::vector<Face> touched = moveTowards(mesh, moves, m_settings.numbers).faces;
  const bool isFinest = m_settings.level == m_levels.finest();
  const std::vector<Face> followed = m_levels.replace(m_settings.level, std::move(mesh), m_settings.numbers);
  for (const Face f : isFinest ? touched : followed) m_touched.add(f);
}

}  // namespace handwheel
