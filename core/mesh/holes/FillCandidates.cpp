// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/FillCandidates.h"

#include "mesh/holes/CreaseFill.h"
#include "mesh/holes/FlatTriangulation.h"
#include "mesh/holes/MinimalTriangulation.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace handwheel {
namespace {

// Weights of ear clipping after the user's own, with and without a lid, for flat loops and for loops that wind through
// space. One may get stuck where another does not.
constexpr EarWeights kEarWeights[] = {{1, 0, 0}, {0.2, 0, 2}, {0, 2, 1}, {3, 1, 0}, {0, 0, 1}, {0.5, 3, 0}};

// A loop is nearly flat if its height along its normal is at most this fraction of its size. Its patch, seen along the
// normal, may cover at most kFlatOverhang more than the loop does, unless it bends with the surroundings.
constexpr double kFlatLoop = 0.1;
constexpr double kFlatOverhang = 0.01;

constexpr double kChordPart = 0.5;  // share of the progress for the search for bridges that divide a loop

bool isOptimal(FillMethod method) {
  return method == FillMethod::Area || method == FillMethod::Dihedral;
}

std::size_t optimalPiece(std::size_t loopSize) {
  return loopSize > tolerance::kOptimalFillEdges ? tolerance::kOptimalFillEdges / 2 : tolerance::kOptimalFillEdges;
}

}  // namespace

const std::optional<Patch>& FillCandidates::Start::get() {
  if (!m_isMade) m_made = m_maker();
  m_isMade = true;
  return m_made;
}

const std::optional<Patch>& FillCandidates::Start::refined(const std::function<Made(const Patch&)>& refine) {
  if (!m_isRefined && get()) m_refined = refine(*m_made);
  m_isRefined = true;
  return m_refined;
}

FillCandidates::FillCandidates(const HoleContext& hole, const Obstacles& obstacles, const JoinedPoints& joined,
                               const FillOptions& options)
    : m_hole(hole),
      m_obstacles(obstacles),
      m_joined(joined),
      m_options(options),
      m_pieceEdges(isOptimal(options.method) ? std::min(options.pieceEdges, optimalPiece(hole.loopSize))
                                             : options.pieceEdges),
      m_isCut(!options.bridges.empty() || hole.loopSize > m_pieceEdges),
      m_flat([this] { return flat(); }) {
  if (m_isCut) m_starts.emplace_back([this] { return inPieces(FillMethod::Minimal); });
  m_starts.emplace_back([this] { return triangulateMinimal(m_hole, m_progress); });
  for (std::size_t i = 0; i < kBalanced; ++i) m_starts.emplace_back([this, i] { return ears(m_hole, i, m_progress); });

  add(options.method);
  m_ranked = m_makers.size();
  if (!options.tryOthers) return;
  for (FillMethod m : {FillMethod::Fair, FillMethod::Refined, FillMethod::Ear, FillMethod::Minimal}) {
    const bool isAdded = m == options.method || (m == FillMethod::Fair && options.method == FillMethod::Crease);
    if (!isAdded) add(m);
    if (m == FillMethod::Refined && hasEvenTriangles()) m_ranked = m_makers.size();
  }
  // The least bend decides among these, but takes long.
  if (hole.loopSize <= tolerance::kOptimalFillEdges && options.method != FillMethod::Dihedral)
    add(FillMethod::Dihedral);
  if (hole.loopSize == 3) return;  // there is one ear for all weights
  for (std::size_t i = 0; i < std::size(kEarWeights); ++i) {
    m_makers.push_back([this, i] { return ears(m_hole, kBalanced + i, m_progress); });
  }
}

void FillCandidates::add(FillMethod method) {
  switch (method) {
    case FillMethod::Fair:
      for (Continuity continuity : continuities()) addRefined(continuity);
      break;
    case FillMethod::Refined:
      addRefined(std::nullopt);
      break;
    case FillMethod::Ear:
      if (!m_options.bridges.empty()) m_makers.push_back([this] { return inPieces(FillMethod::Ear); });
      for (std::size_t i = kBalanced; i > 0; --i) {
        m_makers.push_back([&start = m_starts[m_starts.size() - i]] { return start.get(); });
      }
      break;
    case FillMethod::Minimal:
      for (std::size_t i = 0; i + kBalanced < m_starts.size(); ++i) {
        m_makers.push_back([&start = m_starts[i]] { return start.get(); });
      }
      break;
    case FillMethod::Area:
    case FillMethod::Dihedral:
      m_makers.push_back([this, method] { return m_isCut ? inPieces(method) : piece(m_hole, method, m_progress); });
      break;
    case FillMethod::Flat:
      m_makers.push_back([this] { return triangulateFlat(m_hole, m_progress); });
      break;
    case FillMethod::Crease:
      for (Continuity continuity : continuities()) {
        if (continuity == Continuity::Position) continue;  // creases do not bulge
        m_makers.push_back([this, continuity] {
          return fillAlongCreases(m_hole, m_obstacles, m_options.density, continuity, m_progress);
        });
      }
      add(FillMethod::Fair);
      break;
    case FillMethod::Cone:
    case FillMethod::ThickenedSheet:
    case FillMethod::Stitched:
    case FillMethod::Removed:
      break;
  }
}

bool FillCandidates::hasEvenTriangles() const {
  return m_options.method == FillMethod::Fair || m_options.method == FillMethod::Crease ||
         m_options.method == FillMethod::Refined;
}

// Returns the wanted continuity, then its substitutes if the patch bulges too far or cannot be computed. A membrane
// never bulges; but who wanted tangents and gets none has another patch.
std::vector<Continuity> FillCandidates::continuities() const {
  std::vector<Continuity> all{m_options.continuity};
  if (m_options.continuity == Continuity::Curvature) all.push_back(Continuity::Tangent);
  if (m_options.continuity != Continuity::Position && m_options.tryOthers) all.push_back(Continuity::Position);
  return all;
}

void FillCandidates::addRefined(std::optional<Continuity> bent) {
  const auto addFrom = [this, bent](Start& start) {
    if (bent && !m_options.guides.empty()) m_makers.push_back([this, &start, bent] { return guided(start, *bent); });
    m_makers.push_back([this, &start, bent]() -> Made {
      const Progress whole = std::exchange(m_progress, m_progress.part(0.0, 0.5));
      if (!start.get()) return std::nullopt;
      const Made& even = start.refined([&](const Patch& patch) { return refined(patch, whole.part(0.5, 0.9)); });
      return even && bent ? fairPatch(m_hole, *even, *bent, {}, whole.part(0.9, 1.0)) : even;
    });
  };
  if (m_options.bridges.empty()) addFrom(m_flat);
  for (Start& start : m_starts) addFrom(start);
}

// The energy is that of the shape that the patch has, so it is faired once more when it has been pulled.
FillCandidates::Made FillCandidates::guided(Start& start, Continuity continuity) {
  if (!start.get()) return std::nullopt;
  const Made& even = start.refined([&](const Patch& patch) { return refined(patch, m_progress); });
  Made faired = even ? fairPatch(m_hole, *even, continuity, {}, m_progress) : std::nullopt;
  if (!faired) return std::nullopt;
  const auto held = guidedPoints(m_hole, *faired, m_options.guides);
  if (held.empty()) return std::nullopt;
  for (int i = 0; i < 2 && faired; ++i) faired = fairPatch(m_hole, std::move(*faired), continuity, held, m_progress);
  return faired;
}

FillCandidates::Made FillCandidates::refined(const Patch& start, Progress progress) const {
  return refinePatch(m_hole, start, m_options.density, m_joined, progress);
}

std::vector<Patch> FillCandidates::evenVersions(const Patch& patch, Progress progress) const {
  std::vector<Patch> versions;
  if (!hasEvenTriangles()) return versions;
  Made even = refined(patch, progress.part(0.0, 0.8));
  if (!even) return versions;
  if (Made membrane = fairPatch(m_hole, *even, Continuity::Position, {}, progress.part(0.8, 1.0)))
    versions.push_back(*membrane);
  versions.push_back(std::move(*even));
  return versions;
}

FillCandidates::Made FillCandidates::flat() {
  return heightOf(m_hole) <= kFlatLoop * m_hole.size() ? triangulateFlat(m_hole, m_progress) : std::nullopt;
}

// The triangles of a patch that stays inside project to as much area as the outline.
bool FillCandidates::spansOutside(const Patch& patch) {
  if (!m_flat.get()) return false;
  const Vec3 vectorArea = vectorAreaOf(m_hole);
  const Vec3 normal = vectorArea.stableNormalized();
  double covered = 0.0;
  for (const Triangle& t : patch.triangles) {
    const Vec3 &a = patch.points[t[0]], &b = patch.points[t[1]], &c = patch.points[t[2]];
    covered += 0.5 * std::abs((b - a).cross(c - a).dot(normal));
  }
  return covered > (1.0 + kFlatOverhang) * 0.5 * vectorArea.norm();
}

FillCandidates::Made FillCandidates::inPieces(FillMethod method) {
  if (!m_bridges) {
    m_bridges = m_options.bridges;
    if (m_bridges->empty())
      *m_bridges = proposeHoleBridges(m_hole, m_obstacles, m_pieceEdges, m_progress.part(0.0, kChordPart));
  }
  const std::optional<std::vector<HolePiece>> pieces = splitHole(m_hole.loopSize, *m_bridges);
  if (!pieces || pieces->size() < 2) return std::nullopt;
  const Progress filling = m_progress.part(kChordPart, 1.0);
  const double n = static_cast<double>(pieces->size());
  std::vector<Patch> patches;
  for (std::size_t i = 0; i < pieces->size(); ++i) {
    if (m_progress.cancelled()) return std::nullopt;
    const Progress one = filling.part(static_cast<double>(i) / n, static_cast<double>(i + 1) / n);
    Made made = piece(contextOf(m_hole, (*pieces)[i]), method, one);
    if (!made) return std::nullopt;
    patches.push_back(std::move(*made));
  }
  Patch whole = joined(m_hole, *pieces, patches);
  whole.method = method;
  whole.bridges = *m_bridges;
  return whole;
}

FillCandidates::Made FillCandidates::piece(const HoleContext& hole, FillMethod method, Progress progress) const {
  if (isOptimal(method)) {
    const Criterion criterion = method == FillMethod::Area ? Criterion::Area : Criterion::Dihedral;
    return triangulateOptimal(hole, criterion, m_obstacles.edgesAmong(hole.loop()), progress);
  }
  if (method == FillMethod::Minimal) {
    if (Made minimal = triangulateMinimal(hole, progress)) return minimal;
  }
  for (std::size_t i = 0; i < kBalanced; ++i) {
    if (Made cut = ears(hole, i, progress)) return cut;
  }
  return std::nullopt;
}

FillCandidates::Made FillCandidates::ears(const HoleContext& hole, std::size_t weightsIndex, Progress progress) const {
  EarWeights weights = weightsIndex < kBalanced ? m_options.ears : kEarWeights[weightsIndex - kBalanced];
  if (weightsIndex == 1) weights.lid = 0.0;
  return clipEars(hole, m_obstacles, weights, progress);
}

}  // namespace handwheel
