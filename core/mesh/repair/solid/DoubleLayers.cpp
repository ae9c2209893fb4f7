// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/solid/DoubleLayers.h"

#include "base/Tolerance.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/Shells.h"
#include "proximity/TriangleHierarchy.h"

#include <algorithm>
#include <numeric>

namespace handwheel {
namespace {

constexpr double kCovered = 0.9;           // least fraction of the area of a layer that is along a larger shell
constexpr double kLayerCosine = 0.5;       // least cosine between the normals of two layers
constexpr std::size_t kMostRebuilds = 32;  // rebuilds of the search structure of the larger shells

// The shells along which others may be layers.
class LargerShells {
 public:
  LargerShells(const HalfEdgeMesh& mesh, Progress progress) : m_mesh(mesh), m_progress(progress) {}

  void add(const std::vector<Face>& shell) {
    if (m_rebuilds == kMostRebuilds) return;
    m_faces.insert(m_faces.end(), shell.begin(), shell.end());
    m_isBuilt = false;
  }

  // Returns true if the face is along one of the shells: each corner and its centre are near.
  bool cover(Face f, double reach) {
    build();
    const TrianglePoints t = m_mesh.points(f);
    const auto centre = m_hierarchy.nearest((t[0] + t[1] + t[2]) / 3.0, reach);
    if (!centre) return false;
    if (unitNormal(t).dot(unitNormal(m_hierarchy.corners(centre->triangle))) < kLayerCosine) return false;
    return std::all_of(t.begin(), t.end(), [&](const Vec3& p) { return m_hierarchy.isWithin(p, reach); });
  }

 private:
  void build() {
    if (m_isBuilt) return;
    ++m_rebuilds;
    m_progress.spend(m_faces.size());
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (const Face f : m_faces) {
      const auto first = static_cast<std::uint32_t>(points.size());
      for (const Vec3& p : m_mesh.points(f)) points.push_back(p);
      triangles.push_back({first, first + 1, first + 2});
    }
    m_hierarchy = TriangleHierarchy(points, triangles, m_progress.part(0.0, 0.0));
    m_isBuilt = true;
  }

  const HalfEdgeMesh& m_mesh;
  Progress m_progress;
  std::vector<Face> m_faces;
  TriangleHierarchy m_hierarchy;
  bool m_isBuilt = false;
  std::size_t m_rebuilds = 0;
};

double areaOf(const HalfEdgeMesh& mesh, const std::vector<Face>& shell) {
  return std::accumulate(shell.begin(), shell.end(), 0.0,
                         [&](double sum, Face f) { return sum + handwheel::areaOf(mesh.points(f)); });
}

bool isOpen(const HalfEdgeMesh& mesh, const std::vector<Face>& shell) {
  return std::any_of(shell.begin(), shell.end(), [&](Face f) {
    return mesh.isBorder(3 * f) || mesh.isBorder(3 * f + 1) || mesh.isBorder(3 * f + 2);
  });
}

}  // namespace

std::vector<Face> findDoubleLayers(const HalfEdgeMesh& mesh, double reach, Progress progress) {
  std::vector<std::vector<Face>> shells = findShells(mesh, progress.part(0.0, 0.1));
  std::erase_if(shells, [](const std::vector<Face>& shell) { return shell.size() < tolerance::kCrumbFaces; });
  std::vector<Face> layers;
  if (progress.cancelled() || shells.size() < 2) return layers;
  std::vector<double> areas;
  for (const std::vector<Face>& shell : shells) areas.push_back(areaOf(mesh, shell));
  std::vector<std::size_t> order(shells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
  LargerShells larger(mesh, progress);
  larger.add(shells[order[0]]);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (progress.cancelled()) return layers;
    progress.set(0.1 + 0.9 * static_cast<double>(i) / static_cast<double>(order.size()));
    const std::vector<Face>& shell = shells[order[i]];
    double uncovered = (1.0 - kCovered) * areas[order[i]];
    if (!isOpen(mesh, shell)) uncovered = -1.0;
    for (std::size_t k = 0; k < shell.size() && uncovered >= 0.0 && !progress.cancelled(); ++k) {
      progress.spend(1);
      if (!larger.cover(shell[k], reach)) uncovered -= handwheel::areaOf(mesh.points(shell[k]));
    }
    if (uncovered >= 0.0) {
      layers.insert(layers.end(), shell.begin(), shell.end());
    } else {
      larger.add(shell);
    }
  }
  return layers;
}

}  // namespace handwheel
