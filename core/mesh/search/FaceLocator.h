// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceHierarchy.h"

#include <functional>
#include <memory>
#include <unordered_set>
#include <vector>

namespace handwheel {

// A spatial search structure for the live faces of a mesh version. Faces without finite corners are never found.
class FaceLocator {
 public:
  // For queries within a box; without a hierarchy: O(n) to build, O(faces in the box) a query.
  FaceLocator(const HalfEdgeMesh& mesh, const Box& within);
  // By a hierarchy of this or of an older version: what changed since is tested face by face.
  FaceLocator(const HalfEdgeMesh& mesh, std::shared_ptr<const FaceHierarchy> older);

  const HalfEdgeMesh& mesh() const { return m_mesh; }

  // Calls visit(face) for each face whose box meets the box (boundaries included) until it returns false. Returns false
  // when a visit did.
  bool forEachInBox(const Box& box, const std::function<bool(Face)>& visit) const;
  // Half-edges of proper faces that leave this position, whatever their vertex is.
  std::vector<HalfEdge> leaving(const Vec3& p) const;

 private:
  HalfEdgeMesh m_mesh;
  std::shared_ptr<const FaceHierarchy> m_older;
  std::unordered_set<Face> m_listed;  // not found by the hierarchy
};

}  // namespace handwheel
