// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/CollisionMesh.h"

#include "collision/FclHierarchy.h"
#include "proximity/ExactOrientation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace handwheel {

namespace {

// The shells of a mesh, which are connected by corners.
class Shells {
 public:
  explicit Shells(const TriangleSoup& soup) : m_next(soup.points.size()), m_isOpen(soup.points.size(), false) {
    std::iota(m_next.begin(), m_next.end(), 0u);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> forth, back, lone;
    for (const Triangle& t : soup.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = t[k], to = t[(k + 1) % 3];
        forth.emplace_back(from, to);
        back.emplace_back(to, from);
        m_next[shellOf(from)] = shellOf(to);
      }
    }
    // A shell is closed if each edge occurs as often in one direction as in the other.
    std::sort(forth.begin(), forth.end());
    std::sort(back.begin(), back.end());
    std::set_symmetric_difference(forth.begin(), forth.end(), back.begin(), back.end(), std::back_inserter(lone));
    for (const auto& edge : lone) m_isOpen[shellOf(edge.first)] = true;
  }

  std::uint32_t shellOf(std::uint32_t point) {
    while (m_next[point] != point) point = m_next[point] = m_next[m_next[point]];
    return point;
  }
  bool isClosed(std::uint32_t shell) const { return !m_isOpen[shell]; }

 private:
  std::vector<std::uint32_t> m_next;  // a forest of disjoint sets
  std::vector<bool> m_isOpen;
};

// Merges points at the same position. numbers: the former indices of its triangles.
TriangleSoup welded(const TriangleSoup& soup, std::vector<std::uint32_t>& numbers) {
  TriangleSoup made;
  std::vector<std::uint32_t> order(soup.points.size()), number(soup.points.size(), kNone);
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::uint32_t i) {
    const Vec3& p = soup.points[i];
    return std::array<double, 3>{p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};  // -0 is 0
  };
  const auto isFinite = [&](std::uint32_t i) { return soup.points[i].allFinite(); };
  std::erase_if(order, [&](std::uint32_t i) { return !isFinite(i); });
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || key(order[k]) != key(order[k - 1])) made.points.push_back(soup.points[order[k]]);
    number[order[k]] = static_cast<std::uint32_t>(made.points.size() - 1);
  }
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    if (!isFinite(t[0]) || !isFinite(t[1]) || !isFinite(t[2])) continue;
    const Triangle mapped{number[t[0]], number[t[1]], number[t[2]]};
    if (mapped[0] == mapped[1] || mapped[1] == mapped[2] || mapped[2] == mapped[0]) continue;
    made.triangles.push_back(mapped);
    numbers.push_back(i);
  }
  return made;
}

// Returns true if the ray from p along z may meet a box. True in doubt.
bool mayMeetRayUp(const fcl::OBBd& box, const Vec3& p) {
  const Vec3 from = box.axis.transpose() * (p - box.To), direction = box.axis.row(2);
  constexpr double kRounding = 1e-9;  // relative to lengths
  const double slack = kRounding * (box.extent.norm() + box.To.norm() + p.norm());
  double first = 0.0, last = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double half = box.extent[k] + slack;
    if (std::abs(direction[k]) < kRounding) {  // it changes by less than the slack along the whole box
      if (std::abs(from[k]) > half + kRounding * box.extent.norm()) return false;
      continue;
    }
    const double a = (-half - from[k]) / direction[k], b = (half - from[k]) / direction[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last;
}

// Returns the crossing of a triangle by the ray from p along z: 1 outwards, -1 inwards, 0 none. The ray is taken to be
// shifted by an infinitesimal in x, and by a smaller one in y, so it meets no edge and no corner, and crosses exactly
// one of the triangles at an edge that a shifted ray would cross. Exact, except for points on the triangle.
int passes(const Vec3& p, const std::array<const Vec3*, 3>& corners) {
  const Vec2 at = p.head<2>();
  int around = 0;  // number of turns of the triangle around the ray, seen from above
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = *corners[k], &b = *corners[(k + 1) % 3];
    const bool isUp = b.y() > p.y();
    if ((a.y() > p.y()) == isUp) continue;
    const Vec3 &lower = isUp ? a : b, &upper = isUp ? b : a;
    if (sideOfLine(lower.head<2>(), upper.head<2>(), at) > 0) around += isUp ? 1 : -1;
  }
  if (around == 0) return 0;
  const int side = ExactPlane(*corners[0], *corners[1], *corners[2]).side(p);
  return side == -around ? around : 0;
}

}  // namespace

CollisionMesh::CollisionMesh(const TriangleSoup& original) {
  auto hierarchy = std::make_unique<Hierarchy>();
  const TriangleSoup soup = welded(original, hierarchy->numbers);
  hierarchy->model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  std::vector<fcl::Triangle> triangles;
  for (const Triangle& t : soup.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  if (!triangles.empty()) {
    hierarchy->model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(soup.points.size()));
    hierarchy->model->addSubModel(soup.points, triangles);
    hierarchy->model->endModel();
    hierarchy->model->computeLocalAABB();
    for (int i = 0; i < hierarchy->model->getNumBVs(); ++i)
      hierarchy->radii.push_back(hierarchy->model->getBV(i).bv.obb.extent.norm());
  }
  Shells shells(soup);
  std::vector<bool> isListed(soup.points.size(), false);
  for (const Triangle& t : soup.triangles) {
    for (const std::uint32_t v : t) m_bounds.extend(soup.points[v]);
    const std::uint32_t shell = shells.shellOf(t[0]);
    hierarchy->isOfClosedShell.push_back(shells.isClosed(shell));
    m_isClosed = m_isClosed || shells.isClosed(shell);
    if (!isListed[shell]) m_shellPoints.push_back(soup.points[t[0]]);
    isListed[shell] = true;
  }
  m_hierarchy = std::move(hierarchy);
}

CollisionMesh::~CollisionMesh() = default;

// Counts the triangles of closed shells that a ray up from the point passes, from below or from above.
bool CollisionMesh::contains(const Vec3& p) const {
  if (!m_isClosed || !m_bounds.contains(p)) return false;
  const auto& model = *m_hierarchy->model;
  int winding = 0;
  std::vector<int> open{0};
  while (!open.empty()) {
    const auto& node = model.getBV(open.back());
    open.pop_back();
    if (!mayMeetRayUp(node.bv.obb, p)) continue;
    if (node.isLeaf()) {
      if (!m_hierarchy->isOfClosedShell[static_cast<std::size_t>(node.primitiveId())]) continue;
      const fcl::Triangle& t = model.tri_indices[node.primitiveId()];
      winding += passes(p, {&model.vertices[t[0]], &model.vertices[t[1]], &model.vertices[t[2]]});
    } else {
      open.push_back(node.leftChild());
      open.push_back(node.rightChild());
    }
  }
  return winding != 0;
}

}  // namespace handwheel
