// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/HoleFiller.h"

#include "mesh/boundary/BoundaryNeedles.h"
#include "mesh/holes/FillCandidates.h"
#include "mesh/holes/PatchStatistics.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/Weld.h"
#include "mesh/structure/WorkingScale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

// Steps of WorkBudget that it takes to make a patch, for each edge of its loop, and to judge it, for each triangle.
constexpr std::size_t kCandidateEffort = 10;
constexpr std::size_t kJudgeEffort = 4;

// For longer loops, the first acceptable patch is taken, because the user is waiting.
constexpr std::size_t kComparedEdges = 500;

// Returns true if the triangles form a surface whose only border is the reversed loop.
bool closesLoop(const Patch& patch) {
  if (patch.triangles.empty()) return false;
  const auto n = static_cast<std::uint32_t>(patch.loopSize);
  const EdgeTable edges(patch.triangles, patch.points.size());
  std::size_t border = 0;
  bool ok = std::none_of(patch.triangles.begin(), patch.triangles.end(), hasRepeatedVertex);
  edges.forEachEdge([&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> run) {
    const auto from = [&](std::size_t i) { return patch.triangles[run[i].halfEdge / 3][run[i].halfEdge % 3]; };
    const auto to = [&](std::size_t i) { return patch.triangles[run[i].halfEdge / 3][(run[i].halfEdge + 1) % 3]; };
    if (run.size() == 1) {
      ++border;
      ok = ok && from(0) < n && to(0) < n && from(0) == (to(0) + 1) % n;
    } else {
      ok = ok && run.size() == 2 && from(0) != from(1);
    }
  });
  return ok && border == n;
}

bool hasDegenerateTriangle(const Patch& patch) {
  return std::any_of(patch.triangles.begin(), patch.triangles.end(),
                     [&](const Triangle& t) { return isDegenerate(corners(patch, t)); });
}

Box grown(const Box& box, double by) {
  return {box.min() - Vec3::Constant(by), box.max() + Vec3::Constant(by)};
}

// Returns the height over its loop, in diagonals of the loop's box, of a patch that continues the faces around it: over
// a round flat loop a spherical cap of half-angle a, whose border leans by a, rises by sin a · tan(a / 2), and the
// diagonal is 2√2 sin a. Returns nothing if the faces are too steep to distinguish a cap from a cut: then a flat lid is
// equally likely.
double capHeight(const HoleContext& hole) {
  const std::size_t n = hole.loopSize;
  const Vec3 outward = hole.outward().stableNormalized();
  double cosine = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 edge = hole.points[(i + 1) % n] - hole.points[i];
    cosine += edge.cross(hole.apexes[i] - hole.points[i]).stableNormalized().dot(outward) / static_cast<double>(n);
  }
  if (cosine < tolerance::kCapCosine) return 0.0;
  return std::tan(0.5 * std::acos(std::min(1.0, cosine))) / (2.0 * M_SQRT2);
}

// A patch may bulge in proportion to its hole, and out of the model only as far as a cap that continues the
// surroundings.
bool swells(const HoleContext& hole, const Patch& patch, const Box& model) {
  Box loop;
  for (const Vec3& p : hole.loop()) loop.extend(p);
  const double size = loop.diagonal().norm();
  const Box largest = grown(loop, tolerance::kPatchSwelling * size);
  const Box cap = grown(loop, tolerance::kCapSlack * capHeight(hole) * size);
  const Box part = grown(model, tolerance::kModelSwelling * model.diagonal().norm());
  return std::any_of(patch.points.begin(), patch.points.end(),
                     [&](const Vec3& p) { return !largest.contains(p) || (!part.contains(p) && !cap.contains(p)); });
}

// Returns true if a diagonal of the patch joins two loop points that an edge of the surface already joins.
bool doublesAnEdge(const Patch& patch, const JoinedPoints& joined) {
  const auto n = static_cast<std::uint32_t>(patch.loopSize);
  for (const Triangle& t : patch.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (a >= n || b >= n || a == (b + 1) % n || b == (a + 1) % n) continue;
      const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(a, b);
      if (std::binary_search(joined.begin(), joined.end(), edge)) return true;
    }
  }
  return false;
}

}  // namespace

struct HoleFiller::State {
  State(const HalfEdgeMesh& m, Progress progress) : scale(m), mesh(atWork(m)), obstacles(mesh, progress) {
    if (scale.isNeeded()) given = m;
  }

  HalfEdgeMesh atWork(HalfEdgeMesh m) {
    if (scale.isNeeded()) scale.apply(m);
    return m;
  }

  BoundaryLoop atWork(BoundaryLoop loop) const {
    if (!scale.isNeeded()) return loop;
    loop.length = scale.toWork(loop.length);
    loop.centre = scale.toWork(loop.centre);
    loop.box = Box(scale.toWork(loop.box.min()), scale.toWork(loop.box.max()));
    return loop;
  }

  FillFailure judge(const HoleContext& hole, FillCandidates& candidates, const JoinedPoints& joined, Patch& patch,
                    const FillOptions& options, Progress progress) const {
    for (std::size_t i = patch.loopSize; i < patch.points.size(); ++i) {
      if (!patch.points[i].allFinite()) return FillFailure::NoPatch;
      patch.points[i] = rounded(patch.points[i], options.numbers);
      // Equal positions would be one vertex in the file; the intersection test treats them as shared corners.
      if (obstacles.hasVertexAt(patch.points[i])) return FillFailure::SelfIntersecting;
    }
    if (classifyPoints(patch.points).representative.size() < patch.points.size()) return FillFailure::NoPatch;
    if (!closesLoop(patch) || hasDegenerateTriangle(patch)) return FillFailure::NoPatch;
    if (!options.mayCross && doublesAnEdge(patch, joined)) return FillFailure::NoPatch;
    if (swells(hole, patch, obstacles.bounds())) return FillFailure::Bulging;
    if (!options.mayCross && obstacles.hits(patch, progress)) return FillFailure::SelfIntersecting;
    const bool isBent = patch.continuity.value_or(Continuity::Position) != Continuity::Position;
    return !isBent && candidates.spansOutside(patch) ? FillFailure::Bulging : FillFailure::None;
  }

  FillAttempt propose(const BoundaryLoop& loop, const FillOptions& options, const Progress& progress) const;

  WorkingScale scale;
  HalfEdgeMesh mesh;   // at the working scale
  HalfEdgeMesh given;  // the input with the accepted patches, if that is of another scale
  Obstacles obstacles;
};

FillAttempt HoleFiller::State::propose(const BoundaryLoop& loop, const FillOptions& options,
                                       const Progress& progress) const {
  FillAttempt attempt{FillFailure::NoPatch, {}};
  if (loop.halfEdges.size() < 3) return attempt;
  const HoleContext hole = holeContext(mesh, loop);
  const JoinedPoints joined = obstacles.edgesAmong(hole.loop());
  FillCandidates candidates(hole, obstacles, joined, options);
  constexpr double kNoBend = std::numeric_limits<double>::infinity();
  double leastBend = kNoBend;  // radian
  FillAttempt best;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (progress.cancelled()) return {FillFailure::Cancelled, {}};
    // The first candidates are the slowest: they cut the loop into pieces.
    const double begin = i > 0 ? 0.5 + 0.4 * double(i) / double(candidates.size()) : 0.0;
    const Progress span = progress.part(begin, 0.5 + 0.4 * double(i + 1) / double(candidates.size()));
    std::optional<Patch> patch = candidates.make(i, span.part(0.0, 0.7));
    progress.spend(kCandidateEffort * loop.halfEdges.size());
    if (progress.cancelled()) return {FillFailure::Cancelled, {}};
    if (!patch) continue;
    progress.spend(kJudgeEffort * patch->triangles.size());
    const FillFailure failure = judge(hole, candidates, joined, *patch, options, span.part(0.7, 1.0));
    if (progress.cancelled()) return {FillFailure::Cancelled, {}};
    if (failure != FillFailure::None) {
      attempt.failure = std::max(attempt.failure, failure);
      continue;
    }
    if (i < candidates.rankedCount() || hole.loopSize > kComparedEdges) return {failure, std::move(*patch)};
    // Among the substitutes of the chosen method, the one that bends least is taken.
    const double bend = statisticsOf(mesh, loop, *patch).largestBend;
    if (bend < leastBend) best = {failure, std::move(*patch)};
    leastBend = std::min(leastBend, bend);
  }
  if (leastBend < kNoBend) {
    std::vector<Patch> versions = candidates.evenVersions(best.patch, progress.part(0.9, 0.94));
    for (std::size_t i = 0; i < versions.size(); ++i) {
      progress.spend(kJudgeEffort * versions[i].triangles.size());
      const Progress span = progress.part(0.94 + 0.03 * double(i), 0.97 + 0.03 * double(i));
      if (judge(hole, candidates, joined, versions[i], options, span) == FillFailure::None)
        return {FillFailure::None, std::move(versions[i])};
    }
    if (progress.cancelled()) return {FillFailure::Cancelled, {}};
    return best;
  }
  if (loop.isSheetBoundary) return attempt;  // a repair leaves it as it is
  const double reach = tolerance::kNearWeld * obstacles.bounds().diagonal().norm();
  if (!findBoundaryNeedles(mesh, {&loop, 1}, reach).empty()) attempt.failure = FillFailure::NarrowTriangles;
  return attempt;
}

HoleFiller::HoleFiller(const HalfEdgeMesh& mesh, Progress progress)
    : m_state(std::make_unique<State>(mesh, progress)) {}
HoleFiller::~HoleFiller() = default;

const HalfEdgeMesh& HoleFiller::mesh() const {
  return m_state->scale.isNeeded() ? m_state->given : m_state->mesh;
}

FillAttempt HoleFiller::propose(const BoundaryLoop& loop, const FillOptions& options, Progress progress) const {
  FillAttempt attempt = m_state->propose(m_state->atWork(loop), options, progress);
  if (m_state->scale.isNeeded()) {
    for (Vec3& p : attempt.patch.points) p = m_state->scale.fromWork(p);
  }
  return attempt;
}

std::vector<HoleBridge> HoleFiller::proposeHoleBridges(const BoundaryLoop& loop, std::size_t pieceEdges,
                                                       Progress progress) const {
  return handwheel::proposeHoleBridges(holeContext(m_state->mesh, m_state->atWork(loop)), m_state->obstacles,
                                       pieceEdges, progress);
}

void HoleFiller::accept(const BoundaryLoop& loop, const Patch& patch) {
  if (!m_state->scale.isNeeded()) {
    insertPatch(m_state->mesh, loop, patch);
    return m_state->obstacles.add(patch);
  }
  insertPatch(m_state->given, loop, patch);
  Patch atWork = patch;
  for (Vec3& p : atWork.points) p = m_state->scale.toWork(p);
  insertPatch(m_state->mesh, loop, atWork);
  m_state->obstacles.add(atWork);
}

Substitute substituteIn(const Patch& patch, const FillOptions& options) {
  if (patch.method != options.method) return Substitute::OtherMethod;
  return patch.continuity.value_or(options.continuity) < options.continuity ? Substitute::LessSmooth : Substitute::None;
}

void insertPatch(HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch) {
  const std::size_t n = loop.halfEdges.size();
  std::vector<Vertex> vertex(patch.points.size());
  for (std::size_t i = 0; i < n; ++i) {
    const Vertex v = mesh.from(loop.halfEdges[i]);
    const HalfEdge before = loop.halfEdges[(i + n - 1) % n];
    if (mesh.to(before) != v) {  // pinched: the two fans become one vertex's
      for (HalfEdge g : mesh.fan(HalfEdgeMesh::next(before))) mesh.setCorner(g, v);
    }
    vertex[i] = v;
  }
  for (std::size_t i = n; i < patch.points.size(); ++i) vertex[i] = mesh.addVertex(patch.points[i]);

  const auto firstFace = static_cast<Face>(mesh.faceSlots());
  for (const Triangle& t : patch.triangles) mesh.addFace({vertex[t[0]], vertex[t[1]], vertex[t[2]]});
  const EdgeTable edges(patch.triangles, patch.points.size());
  edges.forEachEdge([&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
    const HalfEdge h = 3 * firstFace + run[0].halfEdge;
    if (run.size() == 2) {
      mesh.pair(h, 3 * firstFace + run[1].halfEdge);
    } else {
      mesh.pair(h, loop.halfEdges[high == low + 1 ? low : high]);
    }
  });
}

}  // namespace handwheel
