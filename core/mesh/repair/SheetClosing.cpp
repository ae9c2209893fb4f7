// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/SheetClosing.h"

#include "base/Tolerance.h"
#include "mesh/defects/NonManifoldVertices.h"
#include "mesh/structure/MeshBuilder.h"

#include <algorithm>
#include <limits>

namespace handwheel {
namespace {

double thicknessUnasked(const HalfEdgeMesh& mesh, const std::vector<Face>& faces) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Face f : faces) {
    const TrianglePoints p = mesh.points(f);
    for (std::size_t k = 0; k < 3; ++k) shortest = std::min(shortest, (p[(k + 1) % 3] - p[k]).norm());
  }
  return tolerance::kSheetOffsetEdge * shortest;
}

}  // namespace

SheetTrial thickenAt(HalfEdgeMesh& mesh, std::span<const LoopOfSheet> loops, double thickness, NumberType numbers,
                     Progress progress) {
  constexpr std::size_t kNoSheet = ~std::size_t{0};
  if (loops.empty()) return {};
  std::vector<OpenSheet> sheets;
  std::vector<std::size_t> sheetWith(mesh.faceSlots(), kNoSheet);
  for (const LoopOfSheet& loop : loops) {
    const Face seed = HalfEdgeMesh::face(loop.at);
    if (sheetWith[seed] != kNoSheet) continue;  // another loop of the same sheet
    OpenSheet& sheet = sheets.emplace_back(OpenSheet{sheetOf(mesh, seed), thickness});
    if (!loop.isWanted) sheet.thickness = std::min(thickness, thicknessUnasked(mesh, sheet.faces));
    for (const Face f : sheet.faces) sheetWith[f] = sheets.size() - 1;
  }
  ThickenedSheets made = thickenSheets(mesh, sheets, numbers, progress);
  SheetTrial trial{std::move(made.faces), made.thickness, {}};
  for (const LoopOfSheet& loop : loops)
    trial.isThickened.push_back(made.isThickened[sheetWith[HalfEdgeMesh::face(loop.at)]]);
  relink(mesh, progress);
  return trial;
}

std::set<PointKey> touchingPositions(const HalfEdgeMesh& mesh, Progress progress) {
  std::set<PointKey> positions;
  for (const Vertex v : findNonManifoldVertices(mesh, progress)) positions.insert(positionKey(mesh.position(v)));
  return positions;
}

std::optional<std::vector<Vec3>> separateNewTouchings(HalfEdgeMesh& mesh, const std::set<PointKey>& known,
                                                      NumberType numbers, const SeparationLimits& limits,
                                                      Progress progress) {
  const auto isKnown = [&](Vertex v) { return known.contains(positionKey(mesh.position(v))); };
  std::vector<Vertex> touching = findNonManifoldVertices(mesh, progress.part(0.0, 0.2));
  std::erase_if(touching, isKnown);
  std::vector<Vec3> homes;
  if (touching.empty()) return homes;
  const HalfEdgeMesh before = mesh;
  for (const Vertex v : separateCoincidentVertices(mesh, numbers, progress.part(0.2, 0.8), {}, touching, limits))
    if (v < before.vertexSlots()) homes.push_back(before.position(v));
  relink(mesh, progress.part(0.8, 0.9));
  touching = findNonManifoldVertices(mesh, progress.part(0.9, 1.0));
  if (!std::all_of(touching.begin(), touching.end(), isKnown)) return std::nullopt;
  return homes;
}

bool hasCornerAmong(const HalfEdgeMesh& mesh, const std::vector<Face>& sheet, const std::set<PointKey>& positions) {
  return std::any_of(sheet.begin(), sheet.end(), [&](Face f) { return hasCornerAt(mesh, f, positions); });
}

void countSheets(const HalfEdgeMesh& before, std::span<const ObstructedHole> holes,
                 const std::set<PointKey>& keptCorners, ObstructedClosings& closings) {
  std::vector<bool> isCounted(before.faceSlots(), false);
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const Face seed = HalfEdgeMesh::face(holes[i].loop.halfEdges.front());
    if (!holes[i].back) continue;
    ObstructedClosing& hole = closings.holes[i];
    if (hole.isCutShort) hole.failure = FillFailure::TooMuchEffort;
    const std::vector<Face> sheet = isCounted[seed] ? std::vector<Face>() : sheetOf(before, seed);
    if (!hole.closed && hasCornerAmong(before, sheet, keptCorners)) hole.failure = FillFailure::SheetKeptOpen;
    if (!hole.closed) closings.sheets.leftLoops[keyOf(before, holes[i].loop)] = hole.failure;
    if (sheet.empty()) continue;
    for (const Face f : sheet) isCounted[f] = true;
    if (hole.closed)
      ++closings.sheets.thickened;
    else
      ++closings.sheets.left[hole.failure];
  }
}

}  // namespace handwheel
