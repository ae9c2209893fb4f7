// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/Repair.h"

#include "mesh/boundary/BoundaryNeedles.h"
#include "mesh/boundary/BoundaryVertices.h"
#include "mesh/boundary/Islands.h"
#include "mesh/boundary/Stitching.h"
#include "mesh/defects/Defects.h"
#include "mesh/defects/DuplicateFaces.h"
#include "mesh/defects/InsideOutShells.h"
#include "mesh/holes/HoleSequence.h"
#include "mesh/repair/Cleaning.h"
#include "mesh/repair/CoincidentVertexSeparation.h"
#include "mesh/repair/IslandJoining.h"
#include "mesh/repair/LoopReasons.h"
#include "mesh/repair/ModifiedVertices.h"
#include "mesh/repair/NonOrientableSurfaces.h"
#include "mesh/repair/ObstructedHoles.h"
#include "mesh/repair/RepairBudget.h"
#include "mesh/repair/intersections/FoldedRegionRemoval.h"
#include "mesh/repair/intersections/IntersectionClusters.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/repair/intersections/SolidUnion.h"
#include "mesh/repair/solid/CrackStitching.h"
#include "mesh/repair/solid/DoubleLayers.h"
#include "mesh/repair/solid/FoldSmoothing.h"
#include "mesh/repair/solid/ScanCrumbs.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshDelta.h"
#include "mesh/structure/PositionTriangles.h"
#include "mesh/structure/Shells.h"
#include "mesh/structure/WorkingScale.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace handwheel {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

constexpr int kHardRounds = 4;
// Most repairs need two rounds, of which the last finds nothing to do.
constexpr int kMostRounds = 8;
// Share of the progress for all rounds, and the share of the remainder that each round leaves for the others.
constexpr double kRounds = 0.95;
constexpr double kRestOfRounds = 0.2;

class Repairer {
 public:
  // progress is that of finding the loops.
  Repairer(const HalfEdgeMesh& input, const RepairOptions& options, Progress progress)
      : m_input(input),
        m_mesh(input),
        m_options(options),
        m_results(input, progress),
        m_thickness(options.thickness > 0.0 ? options.thickness : defaultSheetThickness(input)),
        m_efforts(input) {
    if (m_options.goal != RepairGoal::Certain) m_options.cutCrossings = true;
    if (m_options.goal == RepairGoal::Solid) m_options.sheets = SheetHandling::Fill;
    for (const BoundaryLoop& loop : m_results.inputLoops()) {
      const FillFailure reason = reasonToLeave(loop, {loop.id});
      // A folded region around a hole is replaced even if it contains part of an unmarked sheet.
      if (m_reasons.mayClose(reason) || reason == FillFailure::SheetBoundary) continue;
      for (const Vec3& p : loopPoints(m_input, loop)) m_options.fill.keptCorners.insert(positionKey(p));
    }
  }

  // Repeats rounds until one changes nothing, so that another repair() of the result would change nothing either.
  RepairReport run(Progress progress) {
    double from = 0.0;
    if (const std::vector<Face> turned = inconsistentFaces(progress); !turned.empty())
      reverseFaces(m_mesh, turned, progress.part(0.0, 0.0));
    for (m_round = 0; m_round < kMostRounds && !progress.cancelled(); ++m_round) {
      const double to = 1.0 - kRestOfRounds * (1.0 - from);
      const HalfEdgeMesh before = m_mesh;
      if (m_round > 0)
        relink(m_mesh, progress.part(kRounds * from, kRounds * from));  // the mesh is linked as if read from a file
      repairOnce(progress.part(kRounds * from, kRounds * to));
      from = to;
      if (MeshDelta::isEmptyBetween(before, m_mesh)) break;
    }
    if (!progress.cancelled()) finish(progress.part(kRounds, 1.0));
    m_report.isSeparationIncomplete = m_efforts.separation.isSpent();
    m_report.effort = m_efforts.fill.spent() + m_efforts.close.spent();
    m_report.countedEffort = m_efforts.fill.counted() + m_efforts.close.counted();
    m_report.cancelled = progress.cancelled();
    return std::move(m_report);
  }

  const HalfEdgeMesh& mesh() const { return m_mesh; }

 private:
  void repairOnce(Progress progress) {
    clean(progress.part(0.0, 0.3));
    if (!progress.cancelled()) {
      const double longest = tolerance::kOneSidedCut * diagonalOf(m_mesh);
      WorkBudget effort(m_efforts.hard.left() / 2, m_efforts.hard);  // the rest is for holes
      m_report.nonOrientableCuts += closeNonOrientable(m_mesh, m_options.fill, longest, BoundaryCuts::No,
                                                       progress.part(0.3, 0.35).within(effort));
    }
    if (!progress.cancelled()) {
      WorkBudget effort(m_efforts.fill.left() / 4, m_efforts.fill);
      joinIslands(progress.part(0.35, 0.37).within(effort));
    }
    if (m_options.goal == RepairGoal::Solid && !progress.cancelled())
      m_report.removedDebris += removeGuiding(findLooseSheets(m_mesh, progress.part(0.37, 0.37)));
    if (!progress.cancelled()) fill(progress.part(0.37, 0.55));
    // Solids with a common wall touch there, and would be separated next.
    if (m_options.uniteSolids && m_round == 0 && !progress.cancelled()) {
      WorkBudget effort(m_efforts.most(1.0, tolerance::kObstructedHoleBudget), m_efforts.fill);
      unite(progress.part(0.55, 0.6).within(effort));
    }
    if (!progress.cancelled()) closeHard(progress.part(0.6, 0.85));
    if (m_options.replaceFoldedRegions && !progress.cancelled()) replaceFolded(progress.part(0.85, 0.93));
    if (m_options.resolvesIntersections() && !progress.cancelled()) cutCrossings(progress.part(0.93, 0.97));
    if (!progress.cancelled()) separateTouching(progress.part(0.97, 0.975).within(m_efforts.separation));
    if (!progress.cancelled()) m_report.removedDebris += removeNewDebris(m_mesh, m_input, progress.part(0.975, 0.98));
    if (progress.cancelled()) return;
    const std::vector<std::vector<Face>> insideOut = findInsideOutShells(m_mesh, progress.part(0.98, 1.0));
    for (const std::vector<Face>& body : insideOut) reverseShells(m_mesh, body);
    m_report.reversedBodies += insideOut.size();
  }

  void clean(Progress progress) {
    if (!progress.cancelled()) m_report.removedDegenerate += removeDegenerateFaces(m_mesh, progress.part(0.0, 0.15));
    if (m_options.resolvesIntersections() && m_round == 0 && !progress.cancelled())
      cutAtDuplicates(progress.part(0.15, 0.2));
    if (!progress.cancelled()) m_report.removedDuplicates += removeDuplicateFaces(m_mesh, progress.part(0.2, 0.35));
    if (!progress.cancelled()) m_report.removedFlaps += removeFlaps(m_mesh, progress.part(0.35, 0.6));
    if (m_options.goal != RepairGoal::Certain && !progress.cancelled())
      prepare(progress.part(0.6, 0.65).within(m_efforts.close));
    if (m_options.removeDebris && !progress.cancelled())
      m_report.removedDebris += removeDebris(m_mesh, progress.part(0.65, 0.7));
    if (!progress.cancelled()) {
      m_report.mergedVertices +=
          stitchBoundaries(m_mesh, keptVertices(), progress.part(0.7, 0.9), m_options.nearWeld).size();
    }
    if (!progress.cancelled()) m_report.removedDegenerate += removeDegenerateFaces(m_mesh, progress.part(0.9, 1.0));
  }

  // Prepares a scan for the filling of its holes. Fringes are removed after cracks, along which there are none.
  void prepare(Progress progress) {
    const double diagonal = modelDiagonal(m_mesh);
    m_report.removedDebris += removeGuiding(findCrumbs(m_mesh, progress.part(0.0, 0.2)));
    if (m_round > 0) return;
    m_report.removedLayers +=
        remove(findDoubleLayers(m_mesh, tolerance::kLayerReach * diagonal, progress.part(0.2, 0.4)));
    m_report.stitchedCracks += stitchCracks(m_mesh, tolerance::kCrackReach * diagonal, progress.part(0.4, 0.6)).size();
    const SmoothedFolds smoothed = smoothFolds(m_mesh, m_options.fill.numbers, progress.part(0.6, 0.8));
    m_report.smoothedVertices += smoothed.moved.size();
    m_report.measuredNoise = smoothed.noise;
    m_report.removedDebris += removeGuiding(findFringes(m_mesh, progress.part(0.8, 0.9)));
    relink(m_mesh, progress.part(0.9, 0.9));
    m_report.removedDebris += removeGuiding(findCrumbs(m_mesh, progress.part(0.9, 1.0)));
  }

  // Removes crumbs and fringes of holes. They tell where the surface was.
  std::size_t removeGuiding(const std::vector<Face>& faces) {
    for (const Face f : faces) {
      const TrianglePoints t = m_mesh.points(f);
      if (!isClosed(f)) m_options.fill.guides.push_back({(t[0] + t[1] + t[2]) / 3.0, unitNormal(t)});
    }
    return remove(faces);
  }

  bool isClosed(Face f) const {
    return m_mesh.hasOpposite(3 * f) && m_mesh.hasOpposite(3 * f + 1) && m_mesh.hasOpposite(3 * f + 2);
  }

  std::size_t remove(const std::vector<Face>& faces) {
    for (const Face f : faces) m_mesh.removeFace(f);
    return faces.size();
  }

  // Needed only if some half-edges are seams.
  std::vector<Face> inconsistentFaces(const Progress& progress) const {
    for (HalfEdge h = 0; h < m_mesh.halfEdgeSlots(); ++h)
      if (m_mesh.isSeam(h)) return findInconsistentFaces(m_mesh, progress.part(0.0, 0.0));
    return {};
  }

  // Returns false if there was nothing to separate.
  bool part(Progress progress) {
    const HalfEdgeMesh before = m_mesh;
    const auto spareCrossings = [&] {
      const std::size_t were = countSelfIntersections(m_input, m_options.fill.numbers, progress);
      const std::size_t are = countSelfIntersections(m_mesh, m_options.fill.numbers, progress);
      return are < were ? were - are : 0;
    };
    return note(separateCoincidentVertices(m_mesh, m_options.fill.numbers, progress, spareCrossings, {}, spared()),
                before, progress);
  }

  // Separates parts that touch in a vertex without harm to an edge.
  void separateTouching(Progress progress) {
    const HalfEdgeMesh before = m_mesh;
    note(separateTouchingVertices(m_mesh, m_options.fill.numbers, progress, spared()), before, progress);
  }

  // Returns limits that keep open loops in position, and move vertices of the repair in preference to those of the
  // input.
  SeparationLimits spared() const { return {&m_options.fill.keptCorners, static_cast<Vertex>(m_input.vertexSlots())}; }

  bool note(const std::vector<Vertex>& separated, const HalfEdgeMesh& before, const Progress& progress) {
    for (Vertex v : separated) {
      if (v < before.vertexSlots()) m_modifiedHomes.push_back(before.position(v));
    }
    m_report.separatedVertices += separated.size();
    if (!separated.empty()) relink(m_mesh, progress.unlimited());
    return !separated.empty();
  }

  // Returns the vertices of loops that the user wants open.
  std::vector<bool> keptVertices() const {
    std::vector<bool> kept(m_mesh.vertexSlots(), false);
    for (const BoundaryLoop& loop : m_results.inputLoops()) {
      if (!m_options.keepOpen.contains(loop.id)) continue;
      for (HalfEdge h : loop.halfEdges) kept[m_input.from(h)] = kept[m_input.to(h)] = true;
    }
    return kept;
  }

  struct FillableLoops {
    std::vector<BoundaryLoop> loops;
    std::vector<std::set<int>> owners;
  };

  FillableLoops fillableLoops(Progress progress) const {
    FillableLoops found;
    for (BoundaryLoop& loop : findBoundaryLoops(m_mesh, progress)) {
      std::set<int> of = m_results.ownersOf(m_mesh, loop);
      if (reasonToLeave(loop, of) != FillFailure::None) continue;
      found.loops.push_back(std::move(loop));
      found.owners.push_back(std::move(of));
    }
    return found;
  }

  void joinIslands(Progress progress) {
    const HalfEdgeMesh before = m_mesh;
    const std::vector<BoundaryLoop> loops = findBoundaryLoops(m_mesh, progress.part(0.0, 0.1));
    if (progress.cancelled()) return;
    const auto isHole = [&](const BoundaryLoop& loop) {
      return reasonToLeave(loop, m_results.ownersOf(before, loop)) == FillFailure::None;
    };
    const auto isIsland = [&](const BoundaryLoop& loop) {
      return reasonToLeave(loop, m_results.ownersOf(before, loop)) != FillFailure::KeptOpen;
    };
    keepHolesOfKeptIslands(loops, isHole, isIsland);
    const std::vector<std::size_t> joined =
        handwheel::joinIslands(m_mesh, loops, {isHole, isIsland}, m_options.fill, progress.part(0.1, 1.0));
    for (const std::size_t i : joined) m_reasons.noteJoined(m_results.ownersOf(before, loops[i]));
  }

  // A patch around an island would close its boundary, and one across it would cover it.
  void keepHolesOfKeptIslands(const std::vector<BoundaryLoop>& loops,
                              const std::function<bool(const BoundaryLoop&)>& isHole,
                              const std::function<bool(const BoundaryLoop&)>& isIsland) {
    if (m_options.keepOpen.empty() || m_round > 0) return;
    for (const BoundaryLoop& hole : loops) {
      if (!isHole(hole)) continue;
      const std::vector<const BoundaryLoop*> islands = islandBoundaries(m_mesh, hole, loops);
      if (std::all_of(islands.begin(), islands.end(), [&](const BoundaryLoop* island) { return isIsland(*island); }))
        continue;
      const std::set<int> owners = m_results.ownersOf(m_mesh, hole);
      m_options.keepOpen.insert(owners.begin(), owners.end());
      for (const Vec3& p : loopPoints(m_mesh, hole)) m_options.fill.keptCorners.insert(positionKey(p));
    }
  }

  void fill(Progress progress) {
    FillableLoops fillable = fillableLoops(progress.part(0.0, 0.05));
    const double reach = nearWeldReach(m_mesh, m_options.nearWeld);
    if (const std::vector<Face> needles = findBoundaryNeedles(m_mesh, fillable.loops, reach); !needles.empty()) {
      for (const Face f : needles) m_mesh.removeFace(f);
      m_report.removedDegenerate += needles.size();
      fillable = fillableLoops(progress.part(0.05, 0.1));
    }
    const auto& [loops, owners] = fillable;
    const HalfEdgeMesh before = m_mesh;
    const std::vector<HoleFill> fills =
        fillHoles(m_mesh, loops, m_options.fill, progress.part(0.1, 1.0).within(m_efforts.fill));
    for (std::size_t i = 0; i < fills.size(); ++i) {
      LoopResult result;
      result.edges = loops[i].borderEdges;
      result.reason = fills[i].attempt.failure;
      if (result.reason == FillFailure::None) {
        result.outcome = LoopOutcome::Filled;
        result.method = fills[i].attempt.patch.method;
        result.substitute = substituteIn(fills[i].attempt.patch, m_options.fill);
        result.newFaces = fills[i].attempt.patch.triangles.size();
        result.shape = compared(before, loops[i], fills[i].attempt.patch);
      }
      result.milliseconds = fills[i].milliseconds;
      if (m_round > 0 && result.outcome == LoopOutcome::Filled) {
        m_results.replace(result, owners[i]);
      } else {
        m_results.record(result, owners[i]);
      }
    }
  }

  // Cuts and separations may leave slits, which the next round closes. Touching vertices are separated in any case.
  void closeHard(Progress progress) {
    const Progress now = progress.measuredBy(m_efforts.hard);
    for (int round = 0; round < kHardRounds; ++round) {
      const bool closed = !now.cancelled() && closeHardOnce(now);
      const bool parted = !progress.cancelled() && part(now.within(m_efforts.separation));
      if (!closed && !parted) return;
    }
  }

  // Returns false if nothing was closed.
  bool closeHardOnce(Progress progress) {
    std::vector<ObstructedHole> holes;
    std::vector<std::set<int>> owners;
    for (const BoundaryLoop& loop : findBoundaryLoops(m_mesh, progress)) {
      std::set<int> of = m_results.ownersOf(m_mesh, loop);
      const FillFailure reason = reasonToLeave(loop, of);
      const bool back = reason == FillFailure::SheetBoundary;
      if (!m_reasons.mayClose(reason)) continue;
      holes.push_back({loop, back});
      owners.push_back(std::move(of));
    }
    const auto start = Clock::now();
    const ObstructedClosings closings = closeObstructedHoles(m_mesh, holes, m_options.fill, m_thickness, progress);
    m_report.cutFaces += closings.cutFaces;
    m_report.sheets.extend(closings.sheets);
    m_report.separatedVertices += closings.separated.size();
    m_modifiedHomes.insert(m_modifiedHomes.end(), closings.separated.begin(), closings.separated.end());
    const double each = millisecondsSince(start) / std::max(1.0, static_cast<double>(holes.size()));
    bool any = false;
    m_reasons.forget();
    for (std::size_t i = 0; i < closings.holes.size(); ++i) {
      if (closings.holes[i].isCutShort) m_reasons.noteCutShort(owners[i]);
      if (!closings.holes[i].closed) {
        if (holes[i].back) m_reasons.noteSheet(owners[i], closings.holes[i].failure);
        continue;
      }
      any = true;
      LoopResult result;
      result.edges = holes[i].loop.borderEdges;
      result.outcome = LoopOutcome::Filled;
      result.method = closings.holes[i].method;
      result.substitute = closings.holes[i].substitute;
      result.newFaces = closings.holes[i].newFaces;
      result.shape = closings.holes[i].shape;
      result.milliseconds = each;
      m_results.replace(result, owners[i]);
    }
    return any;
  }

  // Loose remnants of cuts are removed too.
  void replaceFolded(Progress progress) {
    std::vector<BoundaryLoop> loops = findBoundaryLoops(m_mesh, progress.part(0.0, 0.05));
    std::erase_if(loops, [&](const BoundaryLoop& loop) {
      const std::set<int> owners = m_results.ownersOf(m_mesh, loop);
      const FillFailure reason = reasonToLeave(loop, owners);
      return reason != FillFailure::None && (reason != FillFailure::SheetBoundary || !owners.empty());
    });
    const std::size_t replaced =
        replaceFoldedRegions(m_mesh, loops, m_options.fill, progress.part(0.05, 0.8).within(m_efforts.tangle));
    m_report.replacedFaces += replaced;
    if (replaced > 0 && !progress.cancelled()) part(progress.part(0.8, 1.0).within(m_efforts.separation));
  }

  // Cuts solids that overlap and have whole faces in common. The inside is known only while both are closed.
  void cutAtDuplicates(const Progress& progress) {
    const PositionTriangles byPosition(m_mesh, progress.part(0.0, 0.1));
    if (progress.cancelled()) return;
    const EdgeTable edges(byPosition.triangles, byPosition.classes.representative.size(), progress.part(0.1, 0.2));
    if (progress.cancelled() || equalFaces(byPosition.triangles, edges, progress.part(0.2, 0.3)).empty()) return;
    cutCrossings(progress.part(0.3, 1.0));
  }

  void unite(Progress progress) { m_report.innerFaces += uniteSolids(m_mesh, m_options.fill.numbers, progress); }

  void cutCrossings(Progress progress) {
    WorkBudget effort(m_efforts.most(1.0, tolerance::kObstructedHoleBudget), m_efforts.fill);
    const Progress now = progress.within(effort);
    // A round that was cut short stays so unless a later one leaves nothing to cut.
    const bool wasCutShort = std::exchange(m_report.isIntersectionRemovalIncomplete, true);
    const double united = m_options.uniteSolids ? 0.5 : 0.0;  // share of the progress
    if (m_options.uniteSolids) unite(now.part(0.0, united));
    const auto pairs = findSelfIntersections(m_mesh, now.part(united, united + 0.3));
    if (!pairs) return;
    const ClusterRemoval cut =
        removeClusterIntersections(m_mesh, *pairs, m_options.fill.numbers, now.part(united + 0.3, 1.0));
    m_report.cutClusters += cut.clusters;
    m_report.isIntersectionRemovalIncomplete = cut.isCutShort || (wasCutShort && !pairs->empty());
  }

  FillFailure reasonToLeave(const BoundaryLoop& loop, const std::set<int>& owners) const {
    return m_reasons.beforeTrying(loop, owners);
  }

  void finish(Progress progress) {
    const bool isSpent = m_efforts.hard.isSpent() || m_efforts.tangle.isSpent();
    m_reasons.conclude(m_results, m_mesh, isSpent, m_report, progress.part(0.0, 0.1));
    m_report.reversedFaces += countReversedFaces(m_input, m_mesh, progress.part(0.1, 0.4));
    m_report.modifiedVertices = modifiedVertices(m_input, m_mesh, std::move(m_modifiedHomes), progress.part(0.4, 0.7));
    m_report.removed = farthestRemovedVertex(m_input, m_mesh, progress.part(0.7, 1.0));
  }

  const HalfEdgeMesh m_input;
  HalfEdgeMesh m_mesh;
  RepairOptions m_options;  // includes the corners of loops that stay open
  HoleOutcomes m_results;
  LoopReasons m_reasons{m_options, m_results.inputLoops()};
  int m_round = 0;
  double m_thickness;                 // mm
  std::vector<Vec3> m_modifiedHomes;  // original positions of moved vertices
  RepairEfforts m_efforts;
  RepairReport m_report;
};

RepairReport repairAtWorkingScale(HalfEdgeMesh& mesh, const RepairOptions& options, const Progress& progress) {
  Repairer repairer(mesh, options, progress.part(0.0, 0.1));
  RepairReport report = repairer.run(progress.part(0.1, 1.0));
  if (!report.cancelled) mesh = repairer.mesh();
  return report;
}

}  // namespace

RepairReport repair(HalfEdgeMesh& mesh, const RepairOptions& options, Progress progress) {
  WorkingScale scale(mesh);
  if (!scale.isNeeded()) return repairAtWorkingScale(mesh, options, progress);
  HalfEdgeMesh work = mesh;
  scale.apply(work);
  RepairOptions scaled = options;
  scaled.thickness = scale.toWork(options.thickness);
  RepairReport report = repairAtWorkingScale(work, scaled, progress);
  if (report.cancelled) return report;
  scale.undo(work);
  mesh = std::move(work);
  SheetThickness& thickness = report.sheets.thickness;
  thickness.least = scale.fromWork(thickness.least);
  thickness.largest = scale.fromWork(thickness.largest);
  report.measuredNoise = scale.fromWork(report.measuredNoise);
  for (LoopResult& loop : report.loops) {
    loop.shape.rise = scale.fromWork(loop.shape.rise);
    loop.shape.size = scale.fromWork(loop.shape.size);
  }
  if (report.removed) {
    report.removed->distance = scale.fromWork(report.removed->distance);
    report.removed->position = scale.fromWork(report.removed->position);
  }
  return report;
}

}  // namespace handwheel
