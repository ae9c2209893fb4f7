// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/HighValenceFans.h"

#include <algorithm>
#include <map>

namespace handwheel {
namespace {

// Least margin of the box around an arc of the unit sphere beyond its ends: covers the rounding of single precision and
// of the lengths.
constexpr double kArcMargin = 1e-6;

// Returns the box around the arc between two unit vectors. Over a chord of length c the arc rises by 1 - cos(a / 2) <=
// c² / 4.
FloatBox boxOfArc(const Vec3& a, const Vec3& b) {
  const double margin = 0.25 * (b - a).squaredNorm() + kArcMargin;
  FloatBox box{Eigen::Array4f::Zero(), Eigen::Array4f::Zero()};
  box.low.head<3>() = (a.cwiseMin(b).array() - margin).cast<float>();
  box.high.head<3>() = (a.cwiseMax(b).array() + margin).cast<float>();
  return box;
}

// Pairs of items whose boxes meet: within each leaf, and with everything behind it in preorder.
bool forEachMeeting(const BoxTree& tree, std::span<const BoxedItem> items,
                    const std::function<bool(std::uint32_t, std::uint32_t)>& visit) {
  const auto visitFrom = [&](std::uint32_t i, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t j = begin; j < end; ++j)
      if (items[i].box.meets(items[j].box) && !visit(items[i].id(), items[j].id())) return false;
    return true;
  };
  for (std::uint32_t leaf = 0; leaf < tree.nodeCount(); ++leaf) {
    if (!tree.node(leaf).isLeaf()) continue;
    const std::uint32_t begin = tree.node(leaf).first(), end = tree.leafEnd(leaf);
    for (std::uint32_t i = begin; i < end; ++i)
      if (!visitFrom(i, i + 1, end)) return false;
    for (std::uint32_t node = leaf + 1; node < tree.nodeCount();) {
      const BoxNode& other = tree.node(node);
      const bool meets = other.box.meets(tree.node(leaf).box);
      for (std::uint32_t i = begin; meets && other.isLeaf() && i < end; ++i)
        if (!visitFrom(i, other.first(), tree.leafEnd(node))) return false;
      node += meets ? 1 : other.size();
    }
  }
  return true;
}

}  // namespace

HighValenceFans::HighValenceFans(std::span<const Vec3> points, std::span<const Triangle> triangles,
                                 std::span<const BoxedItem> items)
    : m_points(points), m_triangles(triangles) {
  std::vector<std::uint32_t> degree(points.size(), 0);
  for (const BoxedItem& item : items)
    for (const std::uint32_t v : triangles[item.id()]) ++degree[v];
  if (std::none_of(degree.begin(), degree.end(), [](std::uint32_t n) { return n > kCrowd; })) return;
  m_fanOf.assign(triangles.size(), kNone);
  std::map<std::uint32_t, std::vector<std::uint32_t>> fans;
  for (const BoxedItem& item : items) {
    const Triangle& t = triangles[item.id()];
    const std::uint32_t v =
        *std::max_element(t.begin(), t.end(), [&](std::uint32_t a, std::uint32_t b) { return degree[a] < degree[b]; });
    if (degree[v] <= kCrowd) continue;
    m_fanOf[item.id()] = v;
    fans[v].push_back(item.id());
  }
  for (auto& [v, fan] : fans) m_fans.push_back(std::move(fan));
}

std::vector<BoxedItem> HighValenceFans::arcsOf(std::span<const std::uint32_t> fan) const {
  std::vector<BoxedItem> arcs;
  arcs.reserve(fan.size());
  for (const std::uint32_t t : fan) {
    const std::uint32_t vertex = m_fanOf[t];
    std::vector<Vec3> ends;
    for (const std::uint32_t v : m_triangles[t]) {
      // Halved, so that nothing overflows.
      if (v != vertex) ends.push_back((0.5 * m_points[v] - 0.5 * m_points[vertex]).stableNormalized());
    }
    arcs.push_back({boxOfArc(ends[0], ends[1])});
    arcs.back().setId(t);
  }
  return arcs;
}

bool HighValenceFans::forEachPair(const std::function<bool(std::uint32_t, std::uint32_t)>& visit,
                                  Progress progress) const {
  for (const std::vector<std::uint32_t>& fan : m_fans) {
    std::vector<BoxedItem> arcs = arcsOf(fan);
    BoxTree tree;
    if (!tree.build(arcs, progress.part(0.0, 0.0)) || !forEachMeeting(tree, arcs, visit)) return false;
  }
  return !progress.cancelled();
}

}  // namespace handwheel
