// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/FoldedRegionRemoval.h"

#include "base/Tolerance.h"
#include "mesh/boundary/BoundaryOwners.h"
#include "mesh/holes/HoleSequence.h"
#include "mesh/repair/ObstructedHoles.h"
#include "mesh/repair/Submesh.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/search/IncrementalHierarchy.h"
#include "mesh/search/SurfaceDistance.h"
#include "mesh/selection/RegionGrowing.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/PositionKey.h"
#include "mesh/structure/PositionTriangles.h"

#include <algorithm>
#include <limits>

namespace handwheel {
namespace {

// A folded region is removed alone first, then with up to this many rings of faces around it.
constexpr int kMostRings = 4;
// Changes are made in a box around the region with this margin, as a share of its size; if they extend beyond it, in a
// larger one.
constexpr double kMargin = 0.5;
constexpr int kMostBoxes = 16;
// A larger region is not folded but the model itself.
constexpr std::size_t kMostFaces = 5'000;
// Fewer faces enclose nothing.
constexpr std::size_t kLeastBody = 4;
// Number of faces scanned for a box in the time that one face takes in a trial.
constexpr std::size_t kRegionScanWork = 20;

using Positions = std::set<PointKey>;

FaceSelection facesAt(const HalfEdgeMesh& mesh, const Positions& positions) {
  return FaceSelection::where(mesh.faceSlots(),
                              [&](Face f) { return mesh.isLive(f) && hasCornerAt(mesh, f, positions); });
}

bool touches(const HalfEdgeMesh& mesh, const FaceSelection& faces, const Positions& positions) {
  const std::vector<Face> all = faces.faces();
  return std::any_of(all.begin(), all.end(), [&](Face f) { return hasCornerAt(mesh, f, positions); });
}

Box boxAround(const HalfEdgeMesh& mesh, const FaceSelection& faces) {
  Box box;
  faces.forEach([&](Face f) { box.extend(boxOf(mesh.points(f))); });
  return box;
}

bool holdsBody(const HalfEdgeMesh& mesh, const FaceSelection& faces) {
  FaceSelection seen;
  for (const Face f : faces.faces()) {
    if (seen.contains(f)) continue;
    const FaceSelection piece = *connectedFaces(mesh, {{f}});
    seen.add(piece);
    FaceSelection outside = piece;
    outside.remove(faces);
    if (outside.empty() && piece.count() >= kLeastBody) return true;
  }
  return false;
}

// Returns the largest distance of these faces of one mesh from the surface of another, mm.
double distanceOf(const HalfEdgeMesh& mesh, const FaceSelection& faces, const HalfEdgeMesh& other, Progress progress) {
  const SurfaceDistance surface(other, progress);
  double most = 0.0;
  faces.forEach([&](Face f) {
    for (const Vec3& p : mesh.points(f)) {
      const auto nearest = surface.from(p);
      most = std::max(most, nearest ? std::abs(nearest->distance) : std::numeric_limits<double>::infinity());
    }
  });
  return most;
}

class Replacer {
 public:
  Replacer(HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, const FillOptions& options, Progress progress)
      : m_mesh(mesh),
        m_loops(numbered(loops)),
        m_options(options),
        m_effort(progress.share(std::numeric_limits<std::size_t>::max())),
        m_progress(progress.measuredBy(m_effort)),
        m_move(tolerance::kFoldedRegionMove * diagonalOf(mesh)),
        m_bodyMove(tolerance::kFoldedRegionBodyMove * diagonalOf(mesh)) {
    m_options.mayCross = false;
    m_options.tryOthers = true;
    m_options.bridges.clear();
  }

  std::size_t run() {
    const BoundaryOwners owners(m_mesh, m_loops);
    std::set<int> tried;
    for (bool isNew = true; isNew && !m_progress.cancelled();) {
      isNew = false;
      for (const BoundaryLoop& loop : findBoundaryLoops(m_mesh, m_progress)) {
        const std::set<int> ids = owners.of(m_mesh, loop);
        if (std::includes(tried.begin(), tried.end(), ids.begin(), ids.end())) continue;
        tried.insert(ids.begin(), ids.end());
        isNew = replaceAround(loop, m_progress);
        if (isNew || m_progress.cancelled()) break;  // loops found before are no longer those of the mesh
      }
    }
    return m_takenOut;
  }

 private:
  static std::vector<BoundaryLoop> numbered(std::span<const BoundaryLoop> some) {
    std::vector<BoundaryLoop> loops(some.begin(), some.end());
    for (std::size_t i = 0; i < loops.size(); ++i) loops[i].id = static_cast<int>(i);
    return loops;
  }

  enum class Trial { Kept, Bad, Outside };  // Outside: a larger box is needed

  bool replaceAround(const BoundaryLoop& loop, Progress progress) {
    Positions corners;
    for (const Vec3& p : loopPoints(m_mesh, loop)) corners.insert(positionKey(p));
    Box reach = loop.box;
    int rings = 0;
    for (int i = 0; i < kMostBoxes; ++i) {
      const Vec3 margin = Vec3::Constant(kMargin * reach.diagonal().norm());
      const Box box(reach.min() - margin, reach.max() + margin);
      const Submesh part(m_mesh, box);
      progress.spend(m_mesh.faceSlots() / kRegionScanWork);
      FaceSelection region = withCrossing(part.mesh(), facesAt(part.mesh(), corners), progress);
      for (int r = 0; r < rings; ++r) region = withRing(part.mesh(), region, progress);
      Trial trial = Trial::Bad;
      while (true) {
        if (progress.cancelled() || region.count() > kMostFaces) return false;
        if (touches(part.mesh(), region, m_options.keptCorners)) return false;
        trial = tryWithout(region, part, box, reach, progress);
        if (trial != Trial::Bad || ++rings > kMostRings) break;
        region = withRing(part.mesh(), region, progress);
      }
      if (trial != Trial::Outside) return trial == Trial::Kept;
    }
    return false;
  }

  FaceSelection withCrossing(const HalfEdgeMesh& mesh, FaceSelection faces, Progress progress) const {
    for (const Face f : intersectionCluster(mesh, faces.faces(), m_options.numbers, progress)) faces.add(f);
    return faces;
  }

  FaceSelection withRing(const HalfEdgeMesh& mesh, const FaceSelection& faces, Progress progress) const {
    Positions corners;
    faces.forEach([&](Face f) {
      for (const Vec3& p : mesh.points(f)) corners.insert(positionKey(p));
    });
    return withCrossing(mesh, facesAt(mesh, corners), progress);
  }

  // Extends reach by the faces that must be inside the box.
  Trial tryWithout(const FaceSelection& region, const Submesh& part, const Box& box, Box& reach, Progress progress) {
    const HalfEdgeMesh& before = part.mesh();
    progress.spend(part.faceCount());
    reach.extend(boxAround(before, region));
    if (!box.contains(reach)) return Trial::Outside;
    HalfEdgeMesh after = before;
    removeFaces(after, region, progress);
    const std::vector<BoundaryLoop> opened = openedBy(before, region, after, progress);
    for (const BoundaryLoop& loop : opened) reach.extend(loop.box);
    if (!box.contains(reach)) return Trial::Outside;
    fillHoles(after, opened, m_options, progress);
    closeWhatIsLeft(before, region, after, progress);
    reach.extend(part.changesIn(after));
    if (!box.contains(reach)) return Trial::Outside;
    if (!isBetter(before, region, after, progress) || progress.cancelled()) return Trial::Bad;
    part.writeBack(m_mesh, after);
    relink(m_mesh, progress.unlimited());
    m_takenOut += region.count();
    return Trial::Kept;
  }

  void closeWhatIsLeft(const HalfEdgeMesh& before, const FaceSelection& region, HalfEdgeMesh& after,
                       Progress progress) {
    std::vector<ObstructedHole> left;
    for (BoundaryLoop& loop : openedBy(before, region, after, progress)) left.push_back({std::move(loop), false});
    closeObstructedHoles(after, left, m_options, 0.0, progress);  // each trial takes its share of the remaining effort
  }

  bool isBetter(const HalfEdgeMesh& before, const FaceSelection& region, const HalfEdgeMesh& after,
                Progress progress) const {
    return openedBy(before, region, after, progress).empty() &&
           countBadEdges(after, progress) < countBadEdges(before, progress) &&
           countSelfIntersections(after, m_options.numbers, progress) <=
               countSelfIntersections(before, m_options.numbers, progress) &&
           distanceOf(before, region, after, progress) <= (holdsBody(before, region) ? m_bodyMove : m_move);
  }

  // Returns the loops along the removed faces.
  static std::vector<BoundaryLoop> openedBy(const HalfEdgeMesh& before, const FaceSelection& region,
                                            const HalfEdgeMesh& after, Progress progress) {
    std::set<EdgeKey> edges;
    region.forEach([&](Face f) {
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) edges.insert(positionKey(before, h));
    });
    std::vector<BoundaryLoop> loops = findBoundaryLoops(after, progress);
    std::erase_if(loops, [&](const BoundaryLoop& loop) {
      return std::none_of(loop.halfEdges.begin(), loop.halfEdges.end(),
                          [&](HalfEdge h) { return edges.contains(positionKey(after, h)); });
    });
    return loops;
  }

  HalfEdgeMesh& m_mesh;
  const std::vector<BoundaryLoop> m_loops;
  FillOptions m_options;
  WorkBudget m_effort;
  const Progress m_progress;
  const double m_move, m_bodyMove;  // largest moves, mm
  std::size_t m_takenOut = 0;
};

}  // namespace

std::size_t replaceFoldedRegions(HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, const FillOptions& options,
                                 Progress progress) {
  if (loops.empty()) return 0;
  return Replacer(mesh, loops, options, progress).run();
}

}  // namespace handwheel
