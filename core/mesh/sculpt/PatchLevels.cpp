// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/PatchLevels.h"

#include "mesh/sculpt/VertexGoals.h"
#include "mesh/structure/MeshDelta.h"

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
    const Vec3 detail = stencils.frame(before, i).transpose() * (p - stencils.position(before, i));
    moves.push_back({stencils.leaving(i), stencils.position(after, i) + stencils.frame(after, i) * detail});
  }
  return moves;
}

// Returns true if a face belongs to the patch, or shares an edge with one of its faces.
bool isAtPatch(const HalfEdgeMesh& mesh, const FaceSelection& patch, Face f) {
  if (f >= mesh.faceSlots()) return false;
  if (patch.contains(f)) return true;
  for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
    if (mesh.hasOpposite(h) && patch.contains(HalfEdgeMesh::face(mesh.opposite(h)))) return true;
  return false;
}

// Adds dead slots up to the numbers of another mesh. Added vertices get the positions of that mesh.
void addDeadSlots(HalfEdgeMesh& mesh, const HalfEdgeMesh& upTo) {
  while (mesh.vertexSlots() < upTo.vertexSlots())
    mesh.addVertex(upTo.position(static_cast<Vertex>(mesh.vertexSlots())));
  while (mesh.faceSlots() < upTo.faceSlots()) mesh.addFace({kNone, kNone, kNone});
}

// Removes the slots that the step to the finer mesh added at its end, so that undoing an edit restores a level.
void truncateBefore(const SubdivisionStep& step, const HalfEdgeMesh& fine, HalfEdgeMesh& mesh) {
  const auto [vertex, face] = step.firstAdded;
  const std::size_t faces = step.parent.size(), vertices = faces / 2;  // a vertex adds a part to two faces
  const std::size_t vertexSlots = fine.vertexSlots() == vertex + vertices ? vertex : fine.vertexSlots();
  const std::size_t faceSlots = fine.faceSlots() == face + faces ? face : fine.faceSlots();
  if (vertexSlots < mesh.vertexSlots() || faceSlots < mesh.faceSlots()) mesh.truncate(vertexSlots, faceSlots);
}

}  // namespace

PatchLevels::PatchLevels(HalfEdgeMesh mesh, FaceSelection patch) {
  m_levels.push_back({std::move(mesh), std::move(patch), nullptr});
}

bool PatchLevels::addBelow(HalfEdgeMesh mesh, FaceSelection patch, FirstSlots firstAdded) {
  Level& first = m_levels.front();
  std::optional<SubdivisionStep> step = subdivisionBetween(mesh, patch, first.mesh, firstAdded);
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
    const Face first = step.firstAdded.face;
    if (fine >= first && fine - first < step.parent.size()) fine = step.parent[fine - first];
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

bool PatchLevels::follow(const HalfEdgeMesh& after) {
  const HalfEdgeMesh before = mesh();
  const MeshDelta delta = MeshDelta::between(before, after);
  for (const Face f : delta.touchedFaces(before))
    if (isAtPatch(before, patch(), f)) return false;
  m_levels.back().mesh = after;
  for (std::size_t i = finest(); i-- > 0;) {
    Level& level = m_levels[i];
    addDeadSlots(level.mesh, before);
    MeshDelta(delta).swap(level.mesh);
    truncateBefore(*m_levels[i + 1].step, m_levels[i + 1].mesh, level.mesh);
  }
  return true;
}

}  // namespace handwheel
