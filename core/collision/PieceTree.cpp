// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/PieceTree.h"

#include <algorithm>

namespace handwheel {

namespace {

// Returns the bound of a box: the box, and a swept rectangle that contains it, with its longest sides in the rectangle.
fcl::OBBRSSd boundOfBox(const Vec3& half) {
  std::array<Eigen::Index, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return half[a] > half[b]; });
  fcl::OBBRSSd bound;
  bound.obb = fcl::OBBd(Eigen::Matrix3d::Identity(), Vec3::Zero(), half);
  for (Eigen::Index i = 0; i < 2; ++i) bound.rss.axis.col(i) = Vec3::Unit(order[static_cast<std::size_t>(i)]);
  bound.rss.axis.col(2) = bound.rss.axis.col(0).cross(bound.rss.axis.col(1));
  bound.rss.l[0] = 2.0 * half[order[0]];
  bound.rss.l[1] = 2.0 * half[order[1]];
  bound.rss.r = half[order[2]];
  bound.rss.setToFromCenter(Vec3::Zero());
  return bound;
}

// Returns the bound of a cylinder. A swept line bounds it more tightly than a swept rectangle.
fcl::OBBRSSd boundOfCylinder(double radius, double halfLength) {
  fcl::OBBRSSd bound = boundOfBox({radius, radius, halfLength});
  bound.rss.axis << 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0;
  bound.rss.l[0] = 2.0 * halfLength;
  bound.rss.l[1] = 0.0;
  bound.rss.r = radius;
  bound.rss.setToFromCenter(Vec3::Zero());
  return bound;
}

}  // namespace

PieceTree::PieceTree(const CollisionPiece& piece) : m_piece(piece) {
  switch (piece.kind) {
    case CollisionPiece::Kind::Ball:
      m_margin = piece.half.x();
      m_bound = boundOfBox(Vec3::Zero());
      break;
    case CollisionPiece::Kind::Block:
      m_bound = boundOfBox(piece.half);
      break;
    case CollisionPiece::Kind::Cylinder:
      m_bound = boundOfCylinder(piece.half.x(), piece.half.z());
      break;
    case CollisionPiece::Kind::Mesh:
      m_model = piece.mesh->hierarchy().model.get();
      m_radii = piece.mesh->hierarchy().radii.data();
      return;
  }
  m_radius = m_bound.obb.extent.norm();
}

std::array<const Vec3*, 3> PieceTree::corners(std::uint32_t leaf) const {
  const fcl::Triangle& t = m_model->tri_indices[leaf];
  return {&m_model->vertices[t[0]], &m_model->vertices[t[1]], &m_model->vertices[t[2]]};
}

ConvexShape PieceTree::shape(std::uint32_t leaf, const Pose& pose) const {
  if (!m_model) return ConvexShape::ofSolid(m_piece, pose);
  const auto at = corners(leaf);
  return ConvexShape::ofTriangle(pose * *at[0], pose * *at[1], pose * *at[2]);
}

}  // namespace handwheel
