// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/ObstructedHoles.h"

#include "base/Tolerance.h"
#include "mesh/boundary/BoundaryOwners.h"
#include "mesh/repair/ConePatch.h"
#include "mesh/repair/PatchTrial.h"
#include "mesh/repair/SheetClosing.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/search/IncrementalHierarchy.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/PositionTriangles.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace handwheel {
namespace {

struct Attempt {
  FillMethod method;
  double height = 0.0;  // outward height of a cone in the loop's shortest edges
};
// Ordered from the best to the least acceptable shape.
constexpr Attempt kAttempts[] = {{FillMethod::Fair},        {FillMethod::Refined},    {FillMethod::Minimal},
                                 {FillMethod::Ear},         {FillMethod::Cone, -0.1}, {FillMethod::Cone, 0.1},
                                 {FillMethod::Cone, -0.01}, {FillMethod::Cone, 0.01}, {FillMethod::ThickenedSheet}};
// A cone over a longer loop would be a spike.
constexpr std::size_t kConeEdges = 16;
// Only sheets with few faces for their edge are thickened.
constexpr std::size_t kThickenedFacesPerEdge = 4;
// Number of enlargements of a trial's box, if crossing faces extend beyond it, before the whole mesh is used.
constexpr int kNearbyRounds = 4;
// Number of faces scanned for the box in the time that one face takes in a trial.
constexpr std::size_t kScanWork = 20;
// The divisor of the remaining effort that limits one trial, so that failed trials leave effort for the others.
constexpr std::size_t kTrialShare = 4;
// The same for thickening sheets, which is done before the trial of the result: it takes several passes over the mesh.
constexpr std::size_t kThickeningShare = 2;

std::vector<BoundaryLoop> numbered(std::span<const ObstructedHole> holes) {
  std::vector<BoundaryLoop> loops;
  for (const ObstructedHole& hole : holes) {
    loops.push_back(hole.loop);
    loops.back().id = static_cast<int>(loops.size()) - 1;
  }
  return loops;
}

class Closer {
 public:
  Closer(HalfEdgeMesh& mesh, std::span<const ObstructedHole> holes, const FillOptions& options, double thickness,
         Progress progress)
      : m_mesh(mesh),
        m_before(mesh),
        m_holes(holes),
        m_owners(mesh, numbered(holes)),
        m_wanted(options),
        m_options(options),
        m_thickness(thickness),
        m_effort(progress.share(std::numeric_limits<std::size_t>::max())),
        m_progress(progress.measuredBy(m_effort)),
        m_crossings(countSelfIntersections(mesh, options.numbers, m_progress)),
        m_badEdges(countBadEdges(mesh, m_progress)) {
    m_options.mayCross = true;
    m_options.tryOthers = false;
    m_result.holes.resize(holes.size());
  }

  ObstructedClosings run() {
    std::vector<std::size_t> left(m_holes.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    for (const Attempt& attempt : kAttempts) {
      m_attempt = attempt;
      m_options.method = attempt.method;
      m_proposals.clear();
      close(left);
      std::erase_if(left, [&](std::size_t i) { return m_result.holes[i].closed; });
    }
    for (const std::size_t i : left) m_result.holes[i].isCutShort = m_result.holes[i].isCutShort || m_effort.isSpent();
    countSheets(m_before, m_holes, m_options.keptCorners, m_result);
    return std::move(m_result);
  }

 private:
  // A possible closing of a loop of the current mesh: a patch, or a back of its sheet.
  struct Proposal {
    std::size_t hole;
    BoundaryLoop loop;
    std::optional<Patch> patch;
  };

  // The result of a trial. Done: no further trials with these holes are needed.
  enum class Trial { Done, Rejected, CutShort };

  void close(std::span<const std::size_t> some) {
    if (some.empty() || m_progress.cancelled()) return;
    const Trial trial = tryTogether(some);
    if (trial == Trial::Done) return;
    if (some.size() == 1) {
      ObstructedClosing& hole = m_result.holes[some.front()];
      hole.isCutShort = hole.isCutShort || trial == Trial::CutShort;
      return;
    }
    close(some.first(some.size() / 2));
    close(some.subspan(some.size() / 2));
  }

  Trial tryTogether(std::span<const std::size_t> some) {
    if (m_proposals.empty()) propose();
    if (const auto done = tryNearby(some)) return *done;
    HalfEdgeMesh changed = m_mesh;
    std::vector<ObstructedClosing> closings(m_holes.size());
    std::vector<Face> newFaces;
    std::vector<const Proposal*> backs;
    for (const Proposal& p : m_proposals) {
      if (std::find(some.begin(), some.end(), p.hole) == some.end()) continue;
      if (!p.patch) {
        backs.push_back(&p);
        continue;
      }
      for (std::size_t i = 0; i < p.patch->triangles.size(); ++i)
        newFaces.push_back(static_cast<Face>(changed.faceSlots() + i));
      insertPatch(changed, p.loop, *p.patch);
      closeBy(p, closings[p.hole]);
    }
    const std::optional<SheetThickness> thickness = thicken(changed, backs, newFaces, closings);
    if (!thickness) return Trial::CutShort;
    if (newFaces.empty()) return Trial::Done;
    const Trial trial = keepIfSound(std::move(changed), newFaces, closings, !backs.empty());
    if (trial == Trial::Done) m_result.sheets.thickness.extend(*thickness);
    return trial;
  }

  // Does the same with the faces near the holes only. Returns nothing if that does not save much work, or no patches
  // are tried.
  std::optional<Trial> tryNearby(std::span<const std::size_t> some) {
    std::vector<const Proposal*> chosen;
    std::vector<PatchAtLoop> patches;
    Box box;
    for (const Proposal& p : m_proposals) {
      if (std::find(some.begin(), some.end(), p.hole) == some.end()) continue;
      if (!p.patch) return std::nullopt;
      chosen.push_back(&p);
      patches.push_back({&p.loop, &*p.patch});
      for (const Vec3& point : p.patch->points) box.extend(point);
    }
    if (chosen.empty()) return Trial::Done;
    for (int round = 0; round < kNearbyRounds && !m_progress.cancelled(); ++round) {
      const Submesh part(m_mesh, box);
      m_progress.spend(m_mesh.faceSlots() / kScanWork);
      if (part.faceCount() > m_mesh.faceSlots() / 2) return std::nullopt;
      WorkBudget effort = m_progress.share(m_effort.left() / kTrialShare);
      const PatchTrial trial = tryPatches(part, m_mesh, patches, m_options.numbers, m_progress.within(effort));
      if (trial.isOutside) return std::nullopt;
      if (box.contains(trial.reach)) {
        if (trial.isSound) keep(part, trial, chosen);
        return trial.isSound ? Trial::Done : effort.isSpent() ? Trial::CutShort : Trial::Rejected;
      }
      box.extend(trial.reach);
    }
    return std::nullopt;
  }

  // Records that the patch of a proposal closes a hole of the current mesh.
  void closeBy(const Proposal& p, ObstructedClosing& hole) const {
    const PatchComparison shape = compared(m_mesh, p.loop, *p.patch);
    const PatchComparison worst = hole.closed && hole.shape.bend > shape.bend ? hole.shape : shape;
    hole = {true, p.patch->method, substituteIn(*p.patch, m_wanted), hole.newFaces + p.patch->triangles.size(), worst};
  }

  void keep(const Submesh& part, const PatchTrial& trial, const std::vector<const Proposal*>& chosen) {
    m_crossings -= trial.fewerCrossings;
    m_badEdges -= trial.fewerBadEdges;
    m_result.cutFaces += trial.cutFaces;
    for (const Proposal* p : chosen) closeBy(*p, m_result.holes[p->hole]);
    part.writeBack(m_mesh, trial.changed);
    relink(m_mesh, m_progress.unlimited());
    m_proposals.clear();
  }

  // Makes proposals for all remaining holes with the current mesh and method.
  void propose() {
    const HoleFiller filler(m_mesh, m_progress);
    for (const BoundaryLoop& loop : findBoundaryLoops(m_mesh, m_progress)) {
      if (m_progress.cancelled()) return;
      const std::size_t hole = ownerOf(loop);
      if (hole == kNobody) continue;
      if (m_holes[hole].back || m_options.method == FillMethod::ThickenedSheet) {
        if (mayBack(hole, loop)) m_proposals.push_back({hole, loop, {}});
        continue;
      }
      if (m_attempt.method == FillMethod::Cone) {
        if (loop.halfEdges.size() <= kConeEdges)
          m_proposals.push_back({hole, loop, conePatch(m_mesh, loop, m_attempt.height, m_options.numbers)});
        continue;
      }
      FillAttempt attempt = filler.propose(loop, m_options, m_progress);
      if (attempt.failure == FillFailure::None) m_proposals.push_back({hole, loop, std::move(attempt.patch)});
    }
  }

  static constexpr std::size_t kNobody = ~std::size_t{0};

  std::size_t ownerOf(const BoundaryLoop& loop) const {
    for (int id : m_owners.of(m_mesh, loop)) {
      if (!m_result.holes[static_cast<std::size_t>(id)].closed) return static_cast<std::size_t>(id);
    }
    return kNobody;
  }

  // Backs are tried once, and last for surfaces that are no sheets. They close all loops of the sheet.
  bool mayBack(std::size_t hole, const BoundaryLoop& loop) const {
    const bool isSheet = m_holes[hole].back;
    if (isSheet && m_options.method != kAttempts[0].method) return false;
    const std::vector<Face> faces = sheetOf(m_mesh, HalfEdgeMesh::face(loop.halfEdges.front()));
    if (!isSheet && faces.size() > kThickenedFacesPerEdge * loop.halfEdges.size()) return false;
    return !hasCornerAmong(m_mesh, faces, m_options.keptCorners);
  }

  // Returns the reached thickness; nothing if it took too much effort.
  std::optional<SheetThickness> thicken(HalfEdgeMesh& mesh, const std::vector<const Proposal*>& backs,
                                        std::vector<Face>& newFaces, std::vector<ObstructedClosing>& closings) {
    WorkBudget effort = m_progress.share(m_effort.left() / kThickeningShare);
    std::vector<LoopOfSheet> loops;
    loops.reserve(backs.size());
    for (const Proposal* p : backs) loops.push_back({p->loop.halfEdges.front(), m_holes[p->hole].back});
    const SheetTrial made = thickenAt(mesh, loops, m_thickness, m_options.numbers, m_progress.within(effort));
    for (std::size_t i = 0; i < backs.size(); ++i) {
      if (made.isThickened[i])
        closings[backs[i]->hole] = {true, FillMethod::ThickenedSheet};
      else
        m_result.holes[backs[i]->hole].failure = FillFailure::SheetTooThin;
    }
    newFaces.insert(newFaces.end(), made.faces.begin(), made.faces.end());
    if (!backs.empty() && effort.isSpent()) return std::nullopt;
    return made.thickness;
  }

  // With hasBacks, the surface must also touch itself at no more vertices than before.
  Trial keepIfSound(HalfEdgeMesh changed, const std::vector<Face>& newFaces,
                    const std::vector<ObstructedClosing>& closings, bool hasBacks) {
    if (!areFinite(changed, newFaces)) return Trial::Rejected;
    WorkBudget effort = m_progress.share(m_effort.left() / kTrialShare);
    const Progress now = m_progress.within(effort);
    const auto rejected = [&] { return effort.isSpent() ? Trial::CutShort : Trial::Rejected; };
    const IntersectionRemoval report = removeSelfIntersections(changed, newFaces, m_options.numbers, m_crossings, now);
    now.spend(m_mesh.faceSlots());
    if (report.intersectionsAfter > m_crossings) return rejected();
    std::optional<std::vector<Vec3>> separated;
    if (hasBacks) {
      if (!m_touching) m_touching = touchingPositions(m_mesh, now);
      const auto firstNew = static_cast<Vertex>(m_before.vertexSlots());
      separated =
          separateNewTouchings(changed, *m_touching, m_options.numbers, {&m_options.keptCorners, firstNew}, now);
      if (now.cancelled()) m_touching.reset();
      if (!separated) return rejected();
    }
    const std::size_t bad = countBadEdges(changed, now);
    if (now.cancelled() || bad >= m_badEdges) return rejected();
    m_badEdges = bad;
    m_crossings = report.intersectionsAfter;
    m_mesh = std::move(changed);
    m_touching.reset();
    if (separated) m_result.separated.insert(m_result.separated.end(), separated->begin(), separated->end());
    m_proposals.clear();  // their loops are no longer those of the mesh
    if (report.changed) m_result.cutFaces += report.cutFaces;
    for (std::size_t i = 0; i < closings.size(); ++i) {
      if (closings[i].closed) m_result.holes[i] = closings[i];
    }
    return Trial::Done;
  }

  HalfEdgeMesh& m_mesh;
  HalfEdgeMesh m_before;
  std::span<const ObstructedHole> m_holes;
  BoundaryOwners m_owners;
  const FillOptions m_wanted;
  FillOptions m_options;  // for the present attempt
  double m_thickness;
  WorkBudget m_effort;
  Progress m_progress;
  ObstructedClosings m_result;
  std::size_t m_crossings;  // number in the mesh as the file will store it
  std::size_t m_badEdges;
  Attempt m_attempt = kAttempts[0];
  std::vector<Proposal> m_proposals;
  std::optional<std::set<PointKey>> m_touching;  // positions in the mesh; set on the first use
};

}  // namespace

ObstructedClosings closeObstructedHoles(HalfEdgeMesh& mesh, std::span<const ObstructedHole> holes,
                                        const FillOptions& options, double thickness, Progress progress) {
  if (holes.empty()) return {};
  return Closer(mesh, holes, options, thickness, progress).run();
}

}  // namespace handwheel
