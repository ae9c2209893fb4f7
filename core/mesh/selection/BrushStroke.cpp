// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/selection/BrushStroke.h"

#include "proximity/ClosestPoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

constexpr std::uint32_t kPainted = 0x80000000u;
// Largest number of halvings of the path between two events to parts of half a radius.
constexpr int kMostHalvings = 10;
// Number of further halvings if the surface turns away from the viewer, or ends.
constexpr int kSteepHalvings = 4;

// Squared distance between the segments from a to b and from p to q: at the feet of their common perpendicular when
// both lie inside, else at an end.
double squaredDistance(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q) {
  const Vec3 u = b - a, v = q - p, w = p - a;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  const double s = (uw * vv - uv * vw) / determinant, t = (uv * uw - uu * vw) / determinant;
  const bool isInside = determinant > 0.0 && s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0;
  const double inside = isInside ? (w + t * v - s * u).squaredNorm() : std::numeric_limits<double>::infinity();
  const auto toEnd = [](const Vec3& end, const Vec3& from, const Vec3& to) {
    return (closestOnSegment(end, from, to) - end).squaredNorm();
  };
  return std::min({inside, toEnd(a, p, q), toEnd(b, p, q), toEnd(p, a, b), toEnd(q, a, b)});
}

BrushStroke::Touch between(const BrushStroke::Touch& a, const BrushStroke::Touch& b) {
  BrushStroke::Touch middle;
  middle.ray = {0.5 * (a.ray.origin + b.ray.origin), a.ray.direction + b.ray.direction};
  middle.ray.direction.stableNormalize();
  middle.radius = 0.5 * (a.radius + b.radius);
  return middle;
}

}  // namespace

BrushStroke::BrushStroke(std::shared_ptr<const FaceHierarchy> faces)
    : m_faces(std::move(faces)), m_marks(m_faces->mesh().faceSlots(), 0u) {}

std::span<const Face> BrushStroke::moveTo(const Touch& touch) {
  m_new.clear();
  if (!touch.ray.isUsable()) return {};
  const Met hit = m_faces->firstHit(touch.ray);
  if (m_touch) {
    paintBetween(*m_touch, m_lastHit, touch, hit, halvings(*m_touch, touch));
  } else if (hit) {
    paintAlong({&*hit, 1}, touch.radius);
  }
  m_touch = touch;
  m_lastHit = hit;
  return m_new;
}

// Returns the number of halvings of the path between the rays until its parts are at most half the radius. The path is
// measured at the depth of the last hit, else of the middle of the model.
int BrushStroke::halvings(const Touch& from, const Touch& to) const {
  const Vec3 reference = m_lastHit ? m_lastHit->point : Vec3(m_faces->bounds().center());
  const auto at = [&](const Ray& ray) {
    return Vec3(ray.origin + std::max(0.0, (reference - ray.origin).dot(ray.direction)) * ray.direction);
  };
  const double parts = (at(from.ray) - at(to.ray)).norm() / (0.5 * std::min(from.radius, to.radius));
  if (!(parts > 1.0)) return 0;
  return static_cast<int>(std::min(std::ceil(std::log2(parts)), static_cast<double>(kMostHalvings)));
}

// depth is the remaining number of halvings; negative for additional ones that the surface needs.
void BrushStroke::paintBetween(const Touch& from, const Met& a, const Touch& to, const Met& b, int depth) {
  const double radius = std::min(from.radius, to.radius);
  const double distance = a && b ? (a->point - b->point).norm() : 0.0;
  const bool isSteep = a.has_value() != b.has_value() || distance > radius;
  if (depth > 0 || (isSteep && depth > -kSteepHalvings)) {
    const Touch middle = between(from, to);
    const Met hit = middle.ray.isUsable() ? m_faces->firstHit(middle.ray) : std::nullopt;
    paintBetween(from, a, middle, hit, depth - 1);
    paintBetween(middle, hit, to, b, depth - 1);
    return;
  }
  if (a && b && distance <= 2.0 * radius) {
    paintAlong(std::array{*a, *b}, to.radius);
  } else if (b) {  // from one surface to another behind it; the previous hit is already painted
    paintAlong({&*b, 1}, to.radius);
  }
}

// Paints the faces that meet the ball on the straight path between the ends and are connected with one of the ends
// inside this capsule: such a face is entered over an edge that meets the capsule too.
void BrushStroke::paintAlong(std::span<const FaceHierarchy::Hit> ends, double radius) {
  const HalfEdgeMesh& mesh = m_faces->mesh();
  ++m_capsule;
  const auto meet = [&](Face f) {
    if ((m_marks[f] & ~kPainted) == m_capsule) return;
    if ((m_marks[f] & kPainted) == 0) m_new.push_back(f);
    m_marks[f] = kPainted | m_capsule;
    m_waiting.push_back(f);
  };
  for (const FaceHierarchy::Hit& end : ends) meet(end.face);
  // Coordinates are relative to one end, to keep the precision far from the origin.
  const Vec3 origin = ends.front().point, axis = ends.back().point - origin;
  while (!m_waiting.empty()) {
    const Face f = m_waiting.back();
    m_waiting.pop_back();
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (!mesh.hasOpposite(h)) continue;
      const Vec3 a = mesh.position(mesh.from(h)) - origin, b = mesh.position(mesh.to(h)) - origin;
      if (squaredDistance(a, b, Vec3::Zero(), axis) <= radius * radius) meet(HalfEdgeMesh::face(mesh.opposite(h)));
    }
  }
}

}  // namespace handwheel
