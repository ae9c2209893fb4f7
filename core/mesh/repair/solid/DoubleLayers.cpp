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

constexpr double kCovered = 0.9;            // least fraction of the area of a layer that is along a larger shell
constexpr double kLayerCosine = 0.5;        // least cosine between the normals of two layers
constexpr double kSharedBoundary = 0.7;     // share of its boundary along which the other side of a wall ends with it
constexpr std::size_t kMostAdditions = 32;  // shells that others are compared with

enum class Cover { None, SameDirection, OppositeDirection };

// Triangles that can be asked what is near them.
class Surroundings {
 public:
  void add(const TrianglePoints& t) {
    const auto first = static_cast<std::uint32_t>(m_points.size());
    m_points.insert(m_points.end(), t.begin(), t.end());
    m_triangles.push_back({first, first + 1, first + 2});
    m_isBuilt = false;
  }

  // Returns the search structure, which is built anew after additions.
  const TriangleHierarchy& get(const Progress& progress) {
    if (!m_isBuilt) {
      progress.spend(m_triangles.size());
      m_hierarchy = TriangleHierarchy(m_points, m_triangles, progress.part(0.0, 0.0));
    }
    m_isBuilt = true;
    return m_hierarchy;
  }

 private:
  std::vector<Vec3> m_points;
  std::vector<Triangle> m_triangles;
  TriangleHierarchy m_hierarchy;
  bool m_isBuilt = false;
};

// The shells along which others may be layers.
class LargerShells {
 public:
  LargerShells(const HalfEdgeMesh& mesh, double reach, Progress progress)
      : m_mesh(mesh), m_reach(reach), m_progress(progress) {}

  void add(const std::vector<Face>& shell) {
    if (++m_additions > kMostAdditions) return;
    for (const Face f : shell) {
      m_faces.add(m_mesh.points(f));
      forEachBorderPoint(f, [&](const Vec3& p) { m_border.add({p, p, p}); });
    }
  }

  // Returns true if the shell is a layer of the others. A layer may look the opposite direction where its triangles
  // were turned over; but the other side of a thin wall has its boundary along that of the wall.
  bool haveLayer(const std::vector<Face>& shell, double area) {
    double same = 0.0, opposite = 0.0, left = area;
    for (const Face f : shell) {
      m_progress.spend(1);
      const double own = areaOf(m_mesh.points(f));
      const Cover cover = coverOf(f);
      left -= own;
      if (cover == Cover::SameDirection) same += own;
      if (cover == Cover::OppositeDirection) opposite += own;
      if (m_progress.cancelled() || same + opposite + left < kCovered * area) return false;
    }
    return same >= kCovered * area || !sharesBoundary(shell);
  }

 private:
  // A face is covered if each corner and its centre are near a larger shell.
  Cover coverOf(Face f) {
    const TriangleHierarchy& faces = m_faces.get(m_progress);
    const TrianglePoints t = m_mesh.points(f);
    const auto centre = faces.nearest((t[0] + t[1] + t[2]) / 3.0, m_reach);
    if (!centre) return Cover::None;
    const double cosine = unitNormal(t).dot(unitNormal(faces.corners(centre->triangle)));
    const bool isNear = std::all_of(t.begin(), t.end(), [&](const Vec3& p) { return faces.isWithin(p, m_reach); });
    if (!isNear || std::abs(cosine) < kLayerCosine) return Cover::None;
    return cosine > 0.0 ? Cover::SameDirection : Cover::OppositeDirection;
  }

  bool sharesBoundary(const std::vector<Face>& shell) {
    const TriangleHierarchy& border = m_border.get(m_progress);
    double all = 0.0, near = 0.0;
    for (const Face f : shell) {
      forEachBorderPoint(f, [&](const Vec3& p) {
        all += 1.0;
        near += border.isWithin(p, 2.0 * m_reach);
      });
    }
    return near > kSharedBoundary * all;
  }

  template <class Visit>
  void forEachBorderPoint(Face f, Visit visit) const {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
      if (m_mesh.isBorder(h)) visit(m_mesh.position(m_mesh.from(h)));
  }

  const HalfEdgeMesh& m_mesh;
  double m_reach;
  Progress m_progress;
  Surroundings m_faces, m_border;  // triangles and border points of these shells; a point is a triangle
  std::size_t m_additions = 0;
};

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
  for (const std::vector<Face>& shell : shells) areas.push_back(areaOfShell(mesh, shell));
  std::vector<std::size_t> order(shells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
  LargerShells larger(mesh, reach, progress);
  larger.add(shells[order[0]]);
  for (std::size_t i = 1; i < order.size() && !progress.cancelled(); ++i) {
    progress.set(0.1 + 0.9 * static_cast<double>(i) / static_cast<double>(order.size()));
    const std::vector<Face>& shell = shells[order[i]];
    if (isOpen(mesh, shell) && larger.haveLayer(shell, areas[order[i]])) {
      layers.insert(layers.end(), shell.begin(), shell.end());
    } else {
      larger.add(shell);
    }
  }
  return layers;
}

}  // namespace handwheel
