// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/CollisionMesh.h"

#include "collision/FclHierarchy.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Each edge once each way, which is what makes an inside, whatever else the mesh is.
bool hasNoBorder(const TriangleSoup& soup) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> forth, back;
  for (const Triangle& t : soup.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      forth.emplace_back(t[k], t[(k + 1) % 3]);
      back.emplace_back(t[(k + 1) % 3], t[k]);
    }
  }
  std::sort(forth.begin(), forth.end());
  std::sort(back.begin(), back.end());
  return !forth.empty() && forth == back;
}

// Points at the same place are one.
TriangleSoup welded(const TriangleSoup& soup) {
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
  for (const Triangle& t : soup.triangles) {
    if (!isFinite(t[0]) || !isFinite(t[1]) || !isFinite(t[2])) continue;
    const Triangle mapped{number[t[0]], number[t[1]], number[t[2]]};
    if (mapped[0] != mapped[1] && mapped[1] != mapped[2] && mapped[2] != mapped[0]) made.triangles.push_back(mapped);
  }
  return made;
}

}  // namespace

CollisionMesh::CollisionMesh(const TriangleSoup& soup) : m_soup(welded(soup)) {
  auto hierarchy = std::make_unique<Hierarchy>();
  hierarchy->model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  std::vector<fcl::Triangle> triangles;
  for (const Triangle& t : m_soup.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  if (!triangles.empty()) {
    hierarchy->model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(m_soup.points.size()));
    hierarchy->model->addSubModel(m_soup.points, triangles);
    hierarchy->model->endModel();
    hierarchy->model->computeLocalAABB();
    for (int i = 0; i < hierarchy->model->getNumBVs(); ++i)
      hierarchy->radii.push_back(hierarchy->model->getBV(i).bv.obb.extent.norm());
  }
  m_hierarchy = std::move(hierarchy);
  for (const Triangle& t : m_soup.triangles) {
    for (const std::uint32_t v : t) m_bounds.extend(m_soup.points[v]);
  }
  m_isClosed = hasNoBorder(m_soup);
}

CollisionMesh::~CollisionMesh() = default;

// Van Oosterom and Strackee 1983, The solid angle of a plane triangle.
bool CollisionMesh::contains(const Vec3& p) const {
  if (!m_isClosed || !m_bounds.contains(p)) return false;
  double sum = 0.0;
  for (const Triangle& t : m_soup.triangles) {
    const Vec3 a = m_soup.points[t[0]] - p, b = m_soup.points[t[1]] - p, c = m_soup.points[t[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return std::abs(sum) > M_PI;  // half of what a point inside sees, over two
}

}  // namespace handwheel
