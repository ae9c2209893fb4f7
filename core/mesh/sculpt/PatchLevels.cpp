// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/PatchLevels.h"

#include "mesh/sculpt/VertexGoals.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace handwheel {
namespace {

// The vertices of the finer level that must move, with their detail, because the coarser one changed.
std::vector<VertexGoal> followingMoves(const LoopStencils& stencils, const HalfEdgeMesh& before,
                                       const HalfEdgeMesh& after, const HalfEdgeMesh& fine) {
  std::vector<VertexGoal> moves;
  for (std::size_t i = 0; i < stencils.size(); ++i) {
    const std::span<const Vertex> sources = stencils.sources(i);
    const bool isSame =
        std::all_of(sources.begin(), sources.end(), [&](Vertex v) { return before.position(v) == after.position(v); });
    if (isSame) continue;
    const Vec3& p = fine.position(fine.from(stencils.leaving(i)));
    const Vec3 detail = stencils.frame(before, i).transpose() * (p - stencils.place(before, i));
    moves.push_back({stencils.leaving(i), stencils.place(after, i) + stencils.frame(after, i) * detail});
  }
  return moves;
}

}  // namespace

PatchLevels::PatchLevels(HalfEdgeMesh mesh, FaceSelection patch) {
  m_levels.push_back({std::move(mesh), std::move(patch), nullptr});
}

bool PatchLevels::addBelow(HalfEdgeMesh mesh, FaceSelection patch) {
  Level& first = m_levels.front();
  std::optional<SubdivisionStep> step = subdivisionBetween(mesh, patch, first.mesh);
  const bool isFree = finest() == 0 && first.patch.empty();
  if (!step || (!isFree && first.patch != step->faces)) return false;
  first.patch = step->faces;
  first.step = std::make_shared<const SubdivisionStep>(std::move(*step));
  m_levels.insert(m_levels.begin(), {std::move(mesh), std::move(patch), nullptr});
  return true;
}

SubdivisionFailure PatchLevels::refine(const SubdivisionLimits& limits) {
  HalfEdgeMesh fine = mesh();
  auto step = std::make_shared<const SubdivisionStep>(subdivide(fine, patch(), limits));
  if (step->failure != SubdivisionFailure::None) return step->failure;
  m_levels.push_back({std::move(fine), step->faces, step});
  return SubdivisionFailure::None;
}

Face PatchLevels::faceAt(std::size_t level, Face fine) const {
  for (std::size_t i = finest(); i > level; --i) {
    const SubdivisionStep& step = *m_levels[i].step;
    if (fine >= step.firstAdded) fine = step.parent[fine - step.firstAdded];
  }
  return fine;
}

std::vector<Face> PatchLevels::replace(std::size_t level, HalfEdgeMesh mesh, NumberType numbers) {
  assert(level < m_levels.size());
  HalfEdgeMesh before = std::exchange(m_levels[level].mesh, std::move(mesh));
  std::vector<Face> faces;
  for (std::size_t i = level + 1; i < m_levels.size(); ++i) {
    Level& fine = m_levels[i];
    const std::vector<VertexGoal> moves = followingMoves(fine.step->stencils, before, m_levels[i - 1].mesh, fine.mesh);
    before = fine.mesh;
    faces = moveTowards(fine.mesh, moves, numbers).faces;
  }
  return faces;
}

}  // namespace handwheel
