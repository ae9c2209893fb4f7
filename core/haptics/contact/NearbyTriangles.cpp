// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/NearbyTriangles.h"

#include "haptics/contact/LineTriangleTest.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

// The cached box extends beyond the displacement by this share of the reach,
constexpr double kMargin = 0.2;
// and a step stays in it as long as this share of the reach is left.
constexpr double kWanted = 0.05;
constexpr double kLeastReach = 16.0;  // skins
// A reach is chosen for which a look-up finds about so many triangles: with fewer, there is a look-up in each tick;
// with more, each sweep passes over all of them.
constexpr double kUsualFaces = 8.0;

// Returns true if all of a triangle, and of the space right above and below it, is farther than a skin from the box.
// The boxes of oblique slivers, as in a round end of a turned part, may meet although the slivers do not.
bool isApart(const TrianglePoints& t, const Vec3& normal, const Box& box, double skin) {
  const Vec3 middle = box.center(), half = 0.5 * box.sizes();
  if (std::abs(normal.dot(middle - t[0])) > normal.cwiseAbs().dot(half) + skin) return true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 out = (t[(k + 1) % 3] - t[k]).cross(normal);
    if (out.dot(middle - t[k]) > out.cwiseAbs().dot(half) + skin * out.norm()) return true;
  }
  return false;
}

}  // namespace

bool NearbyTriangles::begin(const ContactSurface& surface, const Vec3& expected) {
  const bool isSame = m_version == surface.version();
  if (!isSame) m_box.setEmpty();
  m_surface = &surface;
  m_version = surface.version();
  m_skin = surface.skin();
  m_expected = expected;
  m_hasLooked = false;
  m_reach = m_usualReach > 0.0 ? m_usualReach : expected.norm();
  return isSame;
}

void NearbyTriangles::forget() {
  m_box.setEmpty();
  m_usualReach = 0.0;
}

NearbyTriangles::Sweep NearbyTriangles::sweep(const Vec3& p, const Vec3& step) {
  Sweep best;
  m_reach = std::max(m_reach, kLeastReach * m_skin);
  const double length = step.norm();
  double share = inside(p, step);
  if (share * length < std::min(length, kWanted * m_reach)) {
    lookUpAround(p, m_hasLooked ? step : m_expected);
    share = inside(p, step);
  }
  const Vec3 displacement = share * step;
  double crossing = std::numeric_limits<double>::infinity();
  if (m_count <= kCapacity) {
    std::array<std::uint8_t, kCapacity> ahead;
    const std::size_t count = facesAhead(p, displacement, ahead);
    for (std::size_t i = 0; i < count; ++i) test(m_faces[ahead[i]], p, displacement, best, crossing);
  } else {
    // The tip of a fan with many triangles: each is tested directly.
    Box box(p);
    box.extend(p + displacement);
    const Vec3 margin = Vec3::Constant(2.0 * m_skin);
    m_surface->forEachInBox(Box(box.min() - margin, box.max() + margin), [&](const ContactTriangle& t) {
      const Vec3 normal = (t.corners[1] - t.corners[0]).cross(t.corners[2] - t.corners[0]).normalized();
      test({t.corners, normal}, p, displacement, best, crossing);
      return true;
    });
  }
  best.fraction *= share;
  return best;
}

// Finds the faces whose planes the step reaches. Without a branch, like FaceBoxes.
std::size_t NearbyTriangles::facesAhead(const Vec3& p, const Vec3& step,
                                        std::array<std::uint8_t, kCapacity>& ahead) const {
  std::size_t count = 0;
  for (std::uint64_t near = m_boxes.meeting(p, step, m_skin, m_count); near != 0; near &= near - 1) {
    const int i = std::countr_zero(near);
    const Face& face = m_faces[static_cast<std::size_t>(i)];
    const double from = face.normal.dot(p - face.corners[0]);
    const double change = (from < 0.0 ? -1.0 : 1.0) * face.normal.dot(step);
    ahead[count] = static_cast<std::uint8_t>(i);
    count += static_cast<std::size_t>((change < 0.0) & (std::abs(from) + change < 0.5 * m_skin));
  }
  return count;
}

void NearbyTriangles::test(const Face& face, const Vec3& p, const Vec3& step, Sweep& best, double& crossing) const {
  double from = face.normal.dot(p - face.corners[0]);
  double change = face.normal.dot(step);
  const bool wound = from >= 0.0;
  if (!wound) {
    from = -from;
    change = -change;
  }
  const double to = from + change;
  if (!(change < 0.0) || to >= 0.5 * m_skin) return;
  // It goes through, or ends so near that the next step might begin on the other side.
  const double at = to < 0.0 ? from / -change : 1.0;
  if (at >= crossing) return;
  const Vec3 along = to < 0.0 ? step : Vec3(face.normal);
  if (!passesThrough(to < 0.0 ? p : Vec3(p + step), along, face.corners)) return;
  crossing = at;
  best.fraction = std::clamp((from - m_skin) / -change, 0.0, at);
  const double height = from + best.fraction * change;
  best.hit = HalfSpace{wound ? face.normal : Vec3(-face.normal), m_skin - height};
  best.face = {face.corners, wound};
}

double NearbyTriangles::inside(const Vec3& p, const Vec3& step) const {
  if (!m_box.contains(p)) return 0.0;
  double share = 1.0;
  for (int k = 0; k < 3; ++k) {
    const double room = step[k] > 0.0 ? m_box.max()[k] - p[k] : p[k] - m_box.min()[k];
    const double length = std::abs(step[k]);
    share = room < share * length ? room / length : share;
  }
  return share;
}

void NearbyTriangles::lookUpAround(const Vec3& p, const Vec3& displacement) {
  m_hasLooked = true;
  const double length = displacement.norm();
  const double least = kLeastReach * m_skin;
  for (;;) {
    m_box = Box(p);
    if (length > 0.0) m_box.extend(p + displacement * (m_reach / length));
    const Vec3 margin = Vec3::Constant(kMargin * m_reach);
    m_box = Box(m_box.min() - margin, m_box.max() + margin);
    if (gather(Test::Boxes) || gather(Test::Triangles)) break;
    if (m_reach <= least) {
      m_usualReach = m_reach;
      return;
    }
    m_reach = std::max(0.5 * m_reach, least);
  }
  // Without triangles, no further than the tip goes in a tick: later ones may be small.
  m_usualReach = m_count == 0 ? std::min(2.0 * m_reach, m_expected.norm())
                              : m_reach * std::clamp(std::sqrt(kUsualFaces / static_cast<double>(m_count)), 0.5, 2.0);
}

bool NearbyTriangles::gather(Test test) {
  m_count = 0;
  m_boxes.clear(m_box);
  return m_surface->forEachInBox(m_box, [&](const ContactTriangle& t) {
    const Vec3 normal = (t.corners[1] - t.corners[0]).cross(t.corners[2] - t.corners[0]);
    const double length = normal.norm();
    if (!(length > 0.0)) return true;  // no area: its neighbours cover it
    if (test == Test::Triangles && isApart(t.corners, normal / length, m_box, m_skin)) return true;
    if (m_count == kCapacity) {
      ++m_count;
      return false;
    }
    m_boxes.set(m_count, t.corners);
    m_faces[m_count++] = {t.corners, normal / length};
    return true;
  });
}

}  // namespace handwheel
