// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ConvexDistance.h"
#include "collision/FclHierarchy.h"

namespace handwheel {

// A tree of bounding volumes of a piece, with a convex shape in each leaf. The leaves are the triangles of a mesh; a
// solid is one leaf. A sphere is represented by its centre, with its radius as the margin. All coordinates are in the
// frame of the piece, which must outlive the tree.
class PieceTree {
 public:
  explicit PieceTree(const CollisionPiece& piece);
  PieceTree(const PieceTree&) = delete;
  PieceTree& operator=(const PieceTree&) = delete;

  bool isEmpty() const { return m_model && m_model->num_tris == 0; }
  bool isMesh() const { return m_model != nullptr; }
  double margin() const { return m_margin; }  // mm around the shapes; the radius of a sphere
  const fcl::OBBRSSd& bound(int node) const { return m_model ? m_model->getBV(node).bv : m_bound; }
  double radius(int node) const { return m_radii[node]; }  // mm: radius of the sphere around the box of a bound
  bool isLeaf(int node) const { return !m_model || m_model->getBV(node).isLeaf(); }
  int left(int node) const { return m_model->getBV(node).leftChild(); }
  int right(int node) const { return m_model->getBV(node).rightChild(); }
  // Returns the triangle of a leaf by its index in the tree; 0 for a solid.
  std::uint32_t leafOf(int node) const {
    return m_model ? static_cast<std::uint32_t>(m_model->getBV(node).primitiveId()) : 0;
  }
  std::uint32_t leafCount() const { return m_model ? static_cast<std::uint32_t>(m_model->num_tris) : 1; }
  // Returns the shape of a leaf, in a frame in which the piece has this pose.
  ConvexShape shape(std::uint32_t leaf, const Pose& pose) const;
  std::array<const Vec3*, 3> corners(std::uint32_t leaf) const;  // for a mesh only
  // Returns the triangle of a leaf by its index in the original soup; kNone for a solid.
  std::uint32_t triangleOf(std::uint32_t leaf) const {
    return m_model ? m_piece.mesh->hierarchy().numbers[leaf] : kNone;
  }
  const fcl::BVHModel<fcl::OBBRSSd>* model() const { return m_model; }
  std::span<const Vec3> shellPoints() const { return m_piece.mesh->shellPoints(); }  // for a mesh only

 private:
  const CollisionPiece& m_piece;
  const fcl::BVHModel<fcl::OBBRSSd>* m_model = nullptr;
  fcl::OBBRSSd m_bound;
  double m_margin = 0.0;
  double m_radius = 0.0;              // radius of the sphere around m_bound
  const double* m_radii = &m_radius;  // node by node
};

}  // namespace handwheel
