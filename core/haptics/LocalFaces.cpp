// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/LocalFaces.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

// What rounding can add to a triple product, as a share of the product of the lengths: a line that passes an edge or a
// corner that triangles share must hit one of them.
constexpr double kEdgeRounding = 1e-15;

// The box that is looked up stands out around the way by this share of the reach,
constexpr double kMargin = 0.3;
// and a step is taken in it as long as so much of the reach is left.
constexpr double kWanted = 0.25;
constexpr double kLeastReach = 16.0;  // skins

// Whether the line from p along the step passes through the triangle: it sees the corners turn one way (Segura and
// Feito 2001). Swapping two corners changes the sign exactly, so that neighbours agree on their edge.
bool passesThrough(const Vec3& p, const Vec3& step, const TrianglePoints& t) {
  const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const double far = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
  const double error = kEdgeRounding * step.norm() * far;
  const double u = step.dot(b.cross(c)), v = step.dot(c.cross(a)), w = step.dot(a.cross(b));
  return static_cast<bool>(((u >= -error) & (v >= -error) & (w >= -error)) |
                           ((u <= error) & (v <= error) & (w <= error)));  // in one branch, as facesAhead()
}

}  // namespace

LocalFaces::Sweep LocalFaces::sweep(const Vec3& p, const Vec3& step) {
  Sweep best;
  const bool local = lookUp(p, step);
  const double share = inside(p, step);
  const Vec3 way = share * step;
  double crossing = std::numeric_limits<double>::infinity();
  if (local) {
    std::array<std::uint8_t, kCapacity> ahead;
    const std::size_t count = facesAhead(p, way, ahead);
    for (std::size_t i = 0; i < count; ++i) test(m_faces[ahead[i]], p, way, best, crossing);
  } else {
    // Thousands of triangles at one place, such as the tip of a fan: each is looked at where it stands.
    Box box(p);
    box.extend(p + way);
    const Vec3 margin = Vec3::Constant(2.0 * m_skin);
    m_surface.forEachInBox(Box(box.min() - margin, box.max() + margin), [&](const ContactTriangle& t) {
      const Vec3 normal = (t.corners[1] - t.corners[0]).cross(t.corners[2] - t.corners[0]).normalized();
      test({t.corners, normal, t.id}, p, way, best, crossing);
      return true;
    });
  }
  best.fraction *= share;
  return best;
}

// Those whose planes the step reaches. Without a branch: which they are changes from sweep to sweep, and to guess it
// wrong costs a processor more than the sums.
std::size_t LocalFaces::facesAhead(const Vec3& p, const Vec3& step, std::array<std::uint8_t, kCapacity>& ahead) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < m_count; ++i) {
    const Face& face = m_faces[i];
    const double from = face.normal.dot(p - face.corners[0]);
    const double change = (from < 0.0 ? -1.0 : 1.0) * face.normal.dot(step);
    ahead[count] = static_cast<std::uint8_t>(i);
    count += static_cast<std::size_t>((change < 0.0) & (std::abs(from) + change < 0.5 * m_skin));
  }
  return count;
}

void LocalFaces::test(const Face& face, const Vec3& p, const Vec3& step, Sweep& best, double& crossing) const {
  double from = face.normal.dot(p - face.corners[0]);
  double change = face.normal.dot(step);
  const bool wound = from >= 0.0;
  if (!wound) {
    from = -from;
    change = -change;
  }
  const double to = from + change;
  if (!(change < 0.0) || to >= 0.5 * m_skin) return;
  // Where it goes through, or ends so near that the next step might begin on the other side.
  const double at = to < 0.0 ? from / -change : 1.0;
  if (at >= crossing) return;
  const Vec3 along = to < 0.0 ? step : Vec3(face.normal);
  if (!passesThrough(to < 0.0 ? p : Vec3(p + step), along, face.corners)) return;
  crossing = at;
  best.fraction = std::clamp((from - m_skin) / -change, 0.0, at);
  const double height = from + best.fraction * change;
  best.hit = HalfSpace{wound ? face.normal : Vec3(-face.normal), m_skin - height};
  best.triangle = face.id;
  best.wound = wound;
}

double LocalFaces::inside(const Vec3& p, const Vec3& step) const {
  double share = 1.0;
  for (int k = 0; k < 3; ++k) {
    if (step[k] > 0.0) share = std::min(share, (m_box.max()[k] - p[k]) / step[k]);
    if (step[k] < 0.0) share = std::min(share, (m_box.min()[k] - p[k]) / step[k]);
  }
  return std::max(share, 0.0);
}

// False where more triangles meet than there is room for.
bool LocalFaces::lookUp(const Vec3& p, const Vec3& step) {
  m_reach = std::max(m_reach, kLeastReach * m_skin);
  if (m_box.isEmpty()) return lookUpAround(p, m_expected);
  const double length = step.norm();
  const double wanted = std::min(length, kWanted * m_reach);
  if (m_box.contains(p) && inside(p, step) * length >= wanted) return m_count <= kCapacity;
  return lookUpAround(p, step);
}

bool LocalFaces::lookUpAround(const Vec3& p, const Vec3& way) {
  const double length = way.norm();
  const double least = kLeastReach * m_skin;
  for (;;) {
    const Vec3 ahead = length > m_reach ? Vec3(p + way * (m_reach / length)) : Vec3(p + way);
    Box box(p);
    box.extend(ahead);
    const Vec3 margin = Vec3::Constant(kMargin * m_reach);
    m_box = Box(box.min() - margin, box.max() + margin);
    if (gather(m_box)) return true;
    m_crowded = true;
    if (m_reach <= least) return false;
    m_reach = std::max(0.5 * m_reach, least);
  }
}

bool LocalFaces::gather(const Box& box) {
  m_count = 0;
  return m_surface.forEachInBox(box, [&](const ContactTriangle& t) {
    const Vec3 normal = (t.corners[1] - t.corners[0]).cross(t.corners[2] - t.corners[0]);
    const double length = normal.norm();
    if (!(length > 0.0)) return true;  // no area: its neighbours cover it
    if (m_count == kCapacity) {
      ++m_count;
      return false;
    }
    m_faces[m_count++] = {t.corners, normal / length, t.id};
    return true;
  });
}

}  // namespace handwheel
