// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/FaceLocator.h"

#include "mesh/search/IncrementalHierarchy.h"
#include "mesh/structure/MeshDelta.h"

#include <utility>

namespace handwheel {

FaceLocator::FaceLocator(const HalfEdgeMesh& mesh, const Box& within) : m_mesh(mesh) {
  for (Face f = 0; f < mesh.faceSlots(); ++f)
    if (mesh.isLive(f) && boxOf(mesh.points(f)).intersects(within)) m_listed.insert(f);
}

FaceLocator::FaceLocator(const HalfEdgeMesh& mesh, std::shared_ptr<const FaceHierarchy> older)
    : m_mesh(mesh), m_older(std::move(older)) {
  const std::vector<Face> touched = MeshDelta::between(m_older->mesh(), mesh).touchedFaces(m_older->mesh());
  m_listed.insert(touched.begin(), touched.end());
}

bool FaceLocator::forEachInBox(const Box& box, const std::function<bool(Face)>& visit) const {
  const auto visitLive = [&](Face f) {
    if (f >= m_mesh.faceSlots() || !m_mesh.isLive(f)) return true;
    return !boxOf(m_mesh.points(f)).intersects(box) || visit(f);
  };
  for (const Face f : m_listed)
    if (!visitLive(f)) return false;
  return !m_older || m_older->forEachInBox(box, [&](Face f) { return m_listed.contains(f) || visitLive(f); });
}

std::vector<HalfEdge> FaceLocator::leaving(const Vec3& p) const {
  std::vector<HalfEdge> result;
  forEachInBox(Box(p, p), [&](Face f) {
    if (!m_mesh.isProper(f)) return true;
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
      if (m_mesh.position(m_mesh.from(h)) == p) result.push_back(h);
    return true;
  });
  return result;
}

}  // namespace handwheel
