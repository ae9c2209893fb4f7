// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/solid/ScanCrumbs.h"

#include "base/Tolerance.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/boundary/Islands.h"
#include "mesh/structure/Shells.h"

#include <algorithm>

namespace handwheel {
namespace {

constexpr double kLooseShare = 0.2;                 // largest area of a loose sheet, relative to the largest shell
constexpr double kRaggedShare = 0.1;                // least share of fringes in a ragged loop
constexpr std::size_t kMostLoopsWithIslands = 500;  // holes are searched for islands among so many loops

// Returns the faces of islands that are large enough to stay.
FaceSelection largeIslands(const HalfEdgeMesh& mesh, const Progress& progress) {
  FaceSelection islands;
  std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh, progress);
  std::erase_if(loops, [](const BoundaryLoop& loop) { return loop.halfEdges.size() < tolerance::kCrumbFaces / 2; });
  if (loops.size() > kMostLoopsWithIslands) return islands;
  for (const BoundaryLoop& loop : loops) islands.add(findIslands(mesh, loop, loops, progress.part(1.0, 1.0)));
  return islands;
}

int borderEdges(const HalfEdgeMesh& mesh, Face f) {
  return mesh.isBorder(3 * f) + mesh.isBorder(3 * f + 1) + mesh.isBorder(3 * f + 2);
}

}  // namespace

std::vector<Face> findCrumbs(const HalfEdgeMesh& mesh, Progress progress) {
  const std::vector<std::vector<Face>> shells = findShells(mesh, progress.part(0.0, 0.2));
  std::vector<Face> crumbs;
  if (shells.size() < 2) return crumbs;
  std::vector<double> areas;
  std::size_t mostFaces = 0;
  for (const std::vector<Face>& shell : shells) {
    areas.push_back(areaOfShell(mesh, shell));
    mostFaces = std::max(mostFaces, shell.size());
  }
  const double largest = *std::max_element(areas.begin(), areas.end());
  const FaceSelection islands = largeIslands(mesh, progress.part(0.2, 1.0));
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const bool isSmall = areas[i] < tolerance::kDebrisArea * largest &&
                         static_cast<double>(shells[i].size()) < tolerance::kDebrisFaces * double(mostFaces);
    const bool isIsland = shells[i].size() >= tolerance::kCrumbFaces && islands.contains(shells[i].front());
    if (isSmall && !isIsland) crumbs.insert(crumbs.end(), shells[i].begin(), shells[i].end());
  }
  return crumbs;
}

std::vector<Face> findLooseSheets(const HalfEdgeMesh& mesh, Progress progress) {
  const std::vector<std::vector<Face>> shells = findShells(mesh, progress.part(0.0, 0.2));
  std::vector<double> areas;
  for (const std::vector<Face>& shell : shells) areas.push_back(areaOfShell(mesh, shell));
  std::vector<Face> loose;
  if (shells.size() < 2 || progress.cancelled()) return loose;
  std::vector<bool> isSheet(mesh.faceSlots(), false);
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh, progress.part(0.2, 1.0)))
    if (loop.isSheetBoundary) isSheet[HalfEdgeMesh::face(loop.halfEdges.front())] = true;
  const double most = kLooseShare * *std::max_element(areas.begin(), areas.end());
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (areas[i] <= most && std::any_of(shells[i].begin(), shells[i].end(), [&](Face f) { return isSheet[f]; }))
      loose.insert(loose.end(), shells[i].begin(), shells[i].end());
  }
  return loose;
}

std::vector<Face> findFringes(const HalfEdgeMesh& mesh, Progress progress) {
  std::vector<Face> fringes;
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh, progress)) {
    std::vector<Face> teeth;
    for (const HalfEdge h : loop.halfEdges) {
      if (borderEdges(mesh, HalfEdgeMesh::face(h)) > 1) teeth.push_back(HalfEdgeMesh::face(h));
    }
    std::sort(teeth.begin(), teeth.end());
    teeth.erase(std::unique(teeth.begin(), teeth.end()), teeth.end());
    if (double(teeth.size()) >= kRaggedShare * double(loop.halfEdges.size()) && loop.halfEdges.size() > 8)
      fringes.insert(fringes.end(), teeth.begin(), teeth.end());
  }
  std::sort(fringes.begin(), fringes.end());
  fringes.erase(std::unique(fringes.begin(), fringes.end()), fringes.end());
  return fringes;
}

}  // namespace handwheel
