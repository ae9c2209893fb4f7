// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/CgalHoleFilling.h"
#include "mesh/holes/HoleDecomposition.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/holes/PatchRefinement.h"

#include <functional>
#include <optional>

namespace handwheel {

// The candidate patches for a hole, in order of preference. Each is made only on demand.
class FillCandidates {
 public:
  // All arguments must outlive the object.
  FillCandidates(const HoleContext& hole, const Obstacles& obstacles, const JoinedPoints& joined,
                 const FillOptions& options);
  FillCandidates(const FillCandidates&) = delete;
  FillCandidates& operator=(const FillCandidates&) = delete;

  std::size_t size() const { return m_makers.size(); }
  // Returns the number of candidates of which the first acceptable one is best: those of the chosen method and, if that
  // has even triangles, all others that have. They come first. Of the others, the one that bends least is best.
  std::size_t rankedCount() const { return m_ranked; }
  std::optional<Patch> make(std::size_t i, Progress progress) {
    m_progress = progress;
    return m_makers[i]();
  }
  // Returns versions with even triangles of a patch without added points, the best first; none if the chosen method
  // adds no points.
  std::vector<Patch> evenVersions(const Patch& patch, Progress progress) const;
  // Returns true if the hole is nearly flat and the patch, seen from above, covers more than it.
  bool spansOutside(const Patch& patch);

 private:
  static constexpr std::size_t kBalanced = 2;  // number of weightings of ear clipping that are tried first
  using Made = std::optional<Patch>;

  // A triangulation of the loop's points without added points. It is made on the first request.
  class Start {
   public:
    explicit Start(std::function<Made()> maker) : m_maker(std::move(maker)) {}
    const Made& get();
    // Returns the triangulation with even triangles, which are made on the first request.
    const Made& refined(const std::function<Made(const Patch&)>& refine);

   private:
    std::function<Made()> m_maker;
    Made m_made, m_refined;
    bool m_isMade = false, m_isRefined = false;
  };

  void add(FillMethod method);
  bool hasEvenTriangles() const;
  std::vector<Continuity> continuities() const;
  void addRefined(std::optional<Continuity> bent);
  Made refined(const Patch& start, Progress progress) const;
  Made guided(Start& start, Continuity continuity);
  Made flat();
  Made inPieces(FillMethod method);
  Made piece(const HoleContext& hole, FillMethod method, Progress progress) const;
  Made ears(const HoleContext& hole, std::size_t weightsIndex, Progress progress) const;

  const HoleContext& m_hole;
  const Obstacles& m_obstacles;
  const JoinedPoints& m_joined;
  const FillOptions& m_options;
  Progress m_progress;  // progress of the current candidate
  std::size_t m_pieceEdges;
  bool m_isCut;                                      // true if the loop is divided into pieces
  std::optional<std::vector<HoleBridge>> m_bridges;  // bridges between the pieces, set on the first use
  Start m_flat;                 // triangulation in the plane of the loop; none if the loop is not nearly flat
  std::vector<Start> m_starts;  // other initial triangulations for refinement, the best first
  std::vector<std::function<Made()>> m_makers;
  std::size_t m_ranked = 0;
};

}  // namespace handwheel
