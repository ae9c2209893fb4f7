// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/LaplaceSmoothing.h"

#include "mesh/openmesh/OpenMeshCopy.h"

#include <OpenMesh/Tools/Smoother/JacobiLaplaceSmootherT.hh>

namespace handwheel {
namespace {

using JacobiSmoother = OpenMesh::Smoother::JacobiLaplaceSmootherT<OpenMeshSurface>;

// Selects the movable vertices in the copy, and returns half-edges that start at them, in the order of the copy. The
// smoother of OpenMesh moves all vertices if none is selected.
std::vector<HalfEdge> selectPart(OpenMeshCopy& copy, const HalfEdgeMesh& mesh, const FaceSelection& part) {
  std::vector<HalfEdge> leaving(mesh.vertexSlots(), kNone);
  std::vector<bool> isHeld(mesh.vertexSlots(), false);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      leaving[mesh.from(h)] = h;
      if (!part.contains(f)) isHeld[mesh.from(h)] = true;
      if (!mesh.hasOpposite(h)) isHeld[mesh.from(h)] = isHeld[mesh.to(h)] = true;
    }
  }
  std::vector<HalfEdge> free(copy.takenVertices(), kNone);
  for (std::size_t i = 0; i < free.size(); ++i) {
    const Vertex v = copy.vertexOf(i);
    if (isHeld[v]) continue;
    free[i] = leaving[v];
    copy.surface().status(OpenMesh::VertexHandle(int(i))).set_selected(true);
  }
  return free;
}

}  // namespace

LaplaceSmoothed smoothByLaplace(HalfEdgeMesh& mesh, const FaceSelection& part, const LaplaceSmoothing& options) {
  const Progress& progress = options.progress;
  OpenMeshCopy copy;
  if (const auto refusal = copy.take(mesh, progress.part(0.0, 0.2)); refusal != OpenMeshRefusal::None)
    return {refusal, {}};
  if (progress.cancelled()) return {};
  const std::vector<HalfEdge> leaving = selectPart(copy, mesh, part);
  if (std::all_of(leaving.begin(), leaving.end(), [](HalfEdge h) { return h == kNone; })) return {};
  std::vector<VertexGoal> goals;
  try {
    copy.surface().poll(progress);
    JacobiSmoother smoother(copy.surface());
    smoother.initialize(JacobiSmoother::Tangential_and_Normal,
                        options.isBending ? JacobiSmoother::C1 : JacobiSmoother::C0);
    for (int i = 0; i < options.passes; ++i) {
      smoother.smooth(1);
      progress.part(0.2, 0.9).set(double(i + 1) / options.passes);
    }
    for (std::size_t i = 0; i < leaving.size(); ++i)
      if (leaving[i] != kNone)
        goals.push_back({leaving[i], pointOf(copy.surface().point(OpenMesh::VertexHandle(int(i))))});
  } catch (const OpenMeshSurface::Cancelled&) {
    return {};
  }
  return {OpenMeshRefusal::None, moveTowards(mesh, goals, options.numbers, progress.part(0.9, 1.0))};
}

}  // namespace handwheel
