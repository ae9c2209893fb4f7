// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/ContactSurface.h"

#include "base/Tolerance.h"

#include <algorithm>
#include <atomic>
#include <cassert>

namespace handwheel {
namespace {

std::uint64_t nextVersion() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

}  // namespace

ContactSurface::ContactSurface(std::span<const Vec3> points, std::span<const Triangle> triangles, Progress progress) {
  std::vector<ContactTriangle> all;
  all.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    all.push_back({{points[a], points[b], points[c]}, static_cast<std::uint32_t>(i)});
  }
  add(std::move(all), progress);
}

ContactSurface::ContactSurface(std::vector<ContactTriangle> triangles, Progress progress) {
  add(std::move(triangles), progress);
}

ContactSurface::ContactSurface(std::span<const Placed> bodies, const ContactSurface* before)
    : m_version(nextVersion()), m_origin(before ? before->m_origin : m_version) {
  for (const auto& [surface, pose] : bodies) {
    for (Layer layer : surface.m_layers) {
      assert(!layer.placement);
      const Box own = layer.part->bounds();
      const double far = std::max(own.min().norm(), own.max().norm()) + pose.translation().norm();
      const double rounding = 0x1p-46 * far;
      const Box there = own.transformed(pose);
      const Box bounds(there.min() - Vec3::Constant(rounding), there.max() + Vec3::Constant(rounding));
      layer.placement = std::make_shared<const Placement>(Placement{pose, pose.inverse(), bounds, rounding});
      m_layers.push_back(std::move(layer));
      m_bounds.extend(bounds);
    }
  }
}

double ContactSurface::skin() const {
  if (m_bounds.isEmpty()) return 0.0;
  const double far = std::max(m_bounds.min().cwiseAbs().maxCoeff(), m_bounds.max().cwiseAbs().maxCoeff());
  return tolerance::kContactSkin * std::max(diagonal(), 0x1p-20 * far);
}

void ContactSurface::update(std::span<const std::uint32_t> removed, std::span<const ContactTriangle> added) {
  assert(m_layers.empty() || !m_layers.front().placement);
  m_version = nextVersion();
  for (const std::uint32_t id : removed) remove(id);
  for (const ContactTriangle& t : added) remove(t.id);
  if (added.empty()) return;
  std::vector<ContactTriangle> batch(added.begin(), added.end());
  // A layer no larger than the batch joins it, so that each layer holds more than all that come after it. The first is
  // never rebuilt: that would take as long as opening the file.
  while (m_layers.size() > 1 && m_layers.back().part->size() <= batch.size()) {
    const Layer& last = m_layers.back();
    for (std::size_t slot = 0; slot < last.part->size(); ++slot)
      if (!last.dead.contains(slot)) batch.push_back(last.part->triangle(slot));
    m_layers.pop_back();
  }
  add(std::move(batch));
}

void ContactSurface::add(std::vector<ContactTriangle> triangles, Progress progress) {
  const auto part = std::make_shared<const ContactHierarchy>(std::move(triangles), progress);
  if (part->size() == 0) return;
  m_version = nextVersion();
  if (m_origin == 0) m_origin = m_version;
  const std::uint32_t serial = m_nextSerial++;
  for (std::uint32_t slot = 0; slot < part->size(); ++slot) {
    const ContactTriangle& t = part->triangle(slot);
    while (m_locations.size() <= t.id) m_locations.push_back({});
    m_locations.set(t.id, {serial, slot});
    for (const Vec3& corner : t.corners) m_bounds.extend(corner);
  }
  m_layers.push_back({part, PagedIndexSet(part->size()), serial});
}

void ContactSurface::remove(std::uint32_t id) {
  if (id >= m_locations.size() || m_locations[id].serial == kNone) return;
  const Location location = m_locations[id];
  layerOf(location.serial)->dead.insert(location.slot);
  m_locations.set(id, {});
}

ContactSurface::Layer* ContactSurface::layerOf(std::uint32_t serial) {
  const auto found = std::lower_bound(m_layers.begin(), m_layers.end(), serial,
                                      [](const Layer& layer, std::uint32_t s) { return layer.serial < s; });
  return &*found;
}

}  // namespace handwheel
