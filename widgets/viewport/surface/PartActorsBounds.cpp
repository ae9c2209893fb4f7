// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/PartActors.h"

#include <algorithm>

// The extent of the parts, and their hits by a ray.
namespace handwheel {

namespace {

constexpr std::size_t kHoverOutlinePoints = 20'000;  // points of all parts

}  // namespace

void PartActors::updateBounds() {
  m_bounds.setEmpty();
  for (const Part& part : m_parts) {
    const Box& box = part.wanted->outline.box;
    if (box.isEmpty()) continue;
    for (const Vec3& corner : cornersOf(box)) m_bounds.extend(part.description.pose * corner);
  }
}

std::optional<LayerHit> PartActors::firstHit(const Vec3& origin, const Vec3& direction) const {
  std::optional<LayerHit> first;
  for (const Part& part : m_parts) {
    if (!part.wanted->faces || part.wanted->outline.box.isEmpty()) continue;
    const Pose inverse = part.description.pose.inverse();
    const auto hit = part.wanted->faces->firstHit({inverse * origin, inverse.linear() * direction});
    if (hit && (!first || hit->distance <= first->distance))
      first = {part.number, origin + hit->distance * direction, hit->distance};
  }
  return first;
}

std::string PartActors::nameOf(std::uint64_t number) const {
  const auto part = std::find_if(m_parts.begin(), m_parts.end(), [&](const Part& p) { return p.number == number; });
  return part == m_parts.end() ? std::string() : part->description.name;
}

std::vector<Vec3> PartActors::outline() const {
  std::size_t all = 0;
  for (const Part& part : m_parts) all += part.wanted->outline.points.size();
  const std::size_t step = all / kHoverOutlinePoints + 1;
  std::vector<Vec3> points;
  for (const Part& part : m_parts) {
    const std::vector<Vec3>& own = part.wanted->outline.points;
    for (std::size_t i = 0; i < own.size(); i += step) points.push_back(part.description.pose * own[i]);
    // For any number of parts, the points that touch the box of the part are used; they are the last.
    for (std::size_t i = own.size() < 6 ? 0 : own.size() - 6; step > 1 && i < own.size(); ++i) {
      points.push_back(part.description.pose * own[i]);
    }
  }
  return points;
}

}  // namespace handwheel
