// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"

#include "base/Tolerance.h"
#include "mesh/repair/Cleaning.h"
#include "mesh/repair/CoincidentVertexSeparation.h"
#include "mesh/repair/intersections/Autorefinement.h"
#include "mesh/repair/intersections/CoincidentPieces.h"
#include "mesh/repair/intersections/OverlapUnion.h"
#include "mesh/repair/intersections/TouchingWalls.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/PositionTriangles.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace handwheel {
namespace {

// The limit of cuts of a triangle for solids that are united: many bosses may stand on one large triangle.
constexpr std::size_t kCutsPerFaceOfSolids = 5'000;

// Finds the crossings of the mesh as a file of this number type stores it. Returns nothing if cancelled.
std::optional<std::vector<TrianglePair>> crossings(const HalfEdgeMesh& mesh, NumberType numbers, Progress progress) {
  std::vector<Vec3> points(mesh.vertexSlots());
  for (Vertex v = 0; v < points.size(); ++v) points[v] = rounded(mesh.position(v), numbers);
  std::vector<Triangle> triangles(mesh.faceSlots(), Triangle{0, 0, 0});  // dead faces are excluded
  for (Face f = 0; f < triangles.size(); ++f) {
    if (mesh.isLive(f)) triangles[f] = mesh.triangle(f);
  }
  return selfIntersections(points, triangles, progress);
}

// Returns the pairs connected with these faces: all that contain one of them, all that contain a face of those, and so
// on.
std::vector<TrianglePair> cluster(const std::vector<TrianglePair>& pairs, const std::vector<Face>& faces,
                                  std::size_t faceSlots) {
  std::vector<std::vector<std::uint32_t>> pairsOf(faceSlots);
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    pairsOf[pairs[i].first].push_back(i);
    pairsOf[pairs[i].second].push_back(i);
  }
  std::vector<TrianglePair> found;
  std::vector<bool> seen(pairs.size(), false);
  for (std::vector<Face> left = faces; !left.empty();) {
    const Face f = left.back();
    left.pop_back();
    for (std::uint32_t i : pairsOf[f]) {
      if (seen[i]) continue;
      seen[i] = true;
      found.push_back(pairs[i]);
      left.push_back(pairs[i].first == f ? pairs[i].second : pairs[i].first);
    }
  }
  return found;
}

// Replaces faces by their pieces, unpaired.
void replace(HalfEdgeMesh& mesh, const Autorefinement& cuts, const PositionTriangles& byPosition) {
  const std::size_t known = byPosition.classes.representative.size();
  std::vector<Vertex> vertexOf(cuts.points.size(), kNone);
  for (const auto& [f, pieces] : cuts.piecesOf) {
    const Triangle corners = mesh.triangle(f), classes = byPosition.triangles[f];
    const auto vertex = [&](std::uint32_t point) {
      for (int k = 0; k < 3; ++k) {
        if (classes[k] == point) return corners[k];
      }
      if (vertexOf[point] == kNone) {
        vertexOf[point] = point < known ? byPosition.classes.representative[point] : mesh.addVertex(cuts.points[point]);
      }
      return vertexOf[point];
    };
    mesh.removeFace(f);
    for (const Triangle& p : pieces) mesh.addFace({vertex(p[0]), vertex(p[1]), vertex(p[2])});
  }
}

// The soup of a mesh: its faces over positions.
TriangleSoup soupOf(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition) {
  TriangleSoup soup;
  for (Vertex v : byPosition.classes.representative) soup.points.push_back(mesh.position(v));
  soup.triangles = byPosition.triangles;
  return soup;
}

// Walls of solids to unite may consist of many triangles.
SharedPlanes planesOf(const TriangleSoup& soup, std::span<const TrianglePair> pairs, bool isUnion, Progress progress) {
  return isUnion ? findSharedPlanes(soup, pairs, progress, tolerance::kMaxSelfIntersectionPairs)
                 : findSharedPlanes(soup, pairs, progress);
}

std::vector<TrianglePair> unionOf(const std::vector<TrianglePair>& a, const std::vector<TrianglePair>& b) {
  std::vector<TrianglePair> all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

// The faces to start with, or all; walls that touch are included only for the union of solids.
struct Extent {
  const std::vector<Face>* faces = nullptr;  // null: all
  std::optional<std::size_t> most = {};      // largest number of crossings; absent: those of other clusters
  Uniting which = Uniting::SharedWalls;
};

IntersectionRemoval removeWithin(HalfEdgeMesh& mesh, const Extent& extent, NumberType numbers,
                                 const Progress& progress) {
  IntersectionRemoval report;
  const auto before = crossings(mesh, numbers, progress.part(0.0, 0.2));
  if (!before) return report;
  report.intersectionsBefore = report.intersectionsAfter = before->size();
  const PositionTriangles byPosition(mesh, progress.part(0.2, 0.25));
  if (progress.cancelled()) return report;
  const TriangleSoup soup = soupOf(mesh, byPosition);
  const std::vector<TrianglePair> pairs = extent.faces
                                              ? cluster(*before, *extent.faces, mesh.faceSlots())
                                              : unionOf(*before, findTouchingWalls(soup, progress.part(0.25, 0.25)));
  if (pairs.empty() || pairs.size() > tolerance::kMaxSelfIntersectionPairs || progress.cancelled()) return report;
  const std::size_t others = extent.faces ? before->size() - pairs.size() : 0;
  const std::size_t allowed = extent.most.value_or(others);

  HalfEdgeMesh result = mesh;
  // Not done for trials of patches, which are not coplanar with the faces they cross and have no effort to spare.
  const SharedPlanes planes =
      extent.most ? SharedPlanes() : planesOf(soup, pairs, !extent.faces, progress.part(0.25, 0.3));
  const std::size_t mostCuts = extent.faces ? tolerance::kCutsPerFace : kCutsPerFaceOfSolids;
  const Autorefinement cuts = autorefine(soup, pairs, numbers, progress.part(0.3, 0.6), planes, mostCuts);
  report.cutFaces = cuts.piecesOf.size();
  if (progress.cancelled() || cuts.piecesOf.empty()) return report;
  replace(result, cuts, byPosition);
  const auto firstPiece = static_cast<Face>(mesh.faceSlots());
  report.joinedFaces = joinCoincidentPieces(result, firstPiece, progress.part(0.6, 0.63));
  if (progress.cancelled()) return report;
  // A wall is completely inside or outside only if everything is cut.
  if (others == 0) report.innerFaces = uniteAtWalls(result, firstPiece, extent.which, progress.part(0.63, 0.65));
  if (progress.cancelled()) return report;
  relink(result, progress.part(0.65, 0.7));
  removeDegenerateFaces(result, progress.part(0.7, 0.75));
  separateCoincidentVertices(result, numbers, progress.part(0.75, 0.85), [&] {
    const std::size_t made = countSelfIntersections(result, numbers, progress.part(0.85, 0.85));
    return made < allowed ? allowed - made : 0;
  });
  relink(result, progress.part(0.85, 0.88));  // a formerly non-manifold edge may be open now
  const auto after = crossings(result, numbers, progress.part(0.88, 1.0));
  if (!after || progress.cancelled()) return report;
  report.intersectionsAfter = after->size();
  report.changed = after->size() <= allowed;
  if (report.changed) mesh = std::move(result);
  return report;
}

}  // namespace

std::vector<std::pair<Face, Face>> selfIntersectingPairs(const HalfEdgeMesh& mesh, NumberType numbers,
                                                         Progress progress) {
  return crossings(mesh, numbers, progress).value_or(std::vector<TrianglePair>());
}

std::size_t countSelfIntersections(const HalfEdgeMesh& mesh, NumberType numbers, Progress progress) {
  return selfIntersectingPairs(mesh, numbers, progress).size();
}

std::vector<Face> intersectionCluster(const HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers,
                                      Progress progress) {
  std::vector<Face> found;
  const auto pairs = crossings(mesh, numbers, progress);
  if (!pairs) return found;
  for (const auto& [f, g] : cluster(*pairs, faces, mesh.faceSlots())) found.insert(found.end(), {f, g});
  return found;
}

IntersectionRemoval removeSelfIntersections(HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers,
                                            std::size_t allowed, Progress progress) {
  return removeWithin(mesh, {.faces = &faces, .most = allowed}, numbers, progress);
}

IntersectionRemoval removeAllSelfIntersections(HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers,
                                               Progress progress) {
  return removeWithin(mesh, {.faces = &faces}, numbers, progress);
}

IntersectionRemoval uniteIntersecting(HalfEdgeMesh& mesh, NumberType numbers, Progress progress) {
  return removeWithin(mesh, {.which = Uniting::AllSolids}, numbers, progress);
}

}  // namespace handwheel
