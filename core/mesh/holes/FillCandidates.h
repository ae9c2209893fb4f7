// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/CgalHoleFilling.h"
#include "mesh/holes/HoleDecomposition.h"
#include "mesh/holes/HoleFiller.h"

#include <functional>
#include <optional>

namespace handwheel {

// The candidate patches for a hole, in order of preference. Each is made only on demand.
class FillCandidates {
 public:
  // All arguments must outlive the object.
  FillCandidates(const HoleContext& hole, const Obstacles& obstacles, const FillOptions& options);
  FillCandidates(const FillCandidates&) = delete;
  FillCandidates& operator=(const FillCandidates&) = delete;

  std::size_t size() const { return m_makers.size(); }
  // Returns the number of candidates of the chosen method. They come first; the others are substitutes.
  std::size_t ownCount() const { return m_own; }
  std::optional<Patch> make(std::size_t i, Progress progress) {
    m_progress = progress;
    return m_makers[i]();
  }

 private:
  static constexpr std::size_t kBalanced = 2;  // number of weightings of ear clipping that are tried first
  using Made = std::optional<Patch>;

  // A triangulation of the loop's points without added points. It is made on the first request.
  class Start {
   public:
    explicit Start(std::function<Made()> maker) : m_maker(std::move(maker)) {}
    const Made& get();

   private:
    std::function<Made()> m_maker;
    Made m_made;
    bool m_isMade = false;
  };

  void add(FillMethod method);
  std::vector<Continuity> continuities() const;
  void addRefined(std::optional<Continuity> bent);
  Made inPieces(FillMethod method);
  Made piece(const HoleContext& hole, FillMethod method, Progress progress) const;
  Made ears(const HoleContext& hole, std::size_t weightsIndex, Progress progress) const;

  const HoleContext& m_hole;
  const Obstacles& m_obstacles;
  const FillOptions& m_options;
  Progress m_progress;  // progress of the current candidate
  std::size_t m_pieceEdges;
  bool m_isCut;                                      // true if the loop is divided into pieces
  std::optional<std::vector<HoleBridge>> m_bridges;  // bridges between the pieces, set on the first use
  std::vector<Start> m_starts;                       // initial triangulations for refinement, the best first
  std::vector<std::function<Made()>> m_makers;
  std::size_t m_own = 0;
};

}  // namespace handwheel
