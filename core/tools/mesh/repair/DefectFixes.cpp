// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/repair/DefectFixes.h"

#include "mesh/boundary/Stitching.h"
#include "mesh/defects/Defects.h"
#include "mesh/defects/DuplicateFaces.h"
#include "mesh/defects/InsideOutShells.h"
#include "mesh/repair/Cleaning.h"
#include "mesh/repair/CoincidentVertexSeparation.h"
#include "mesh/repair/NonOrientableSurfaces.h"
#include "mesh/repair/SheetThickening.h"
#include "mesh/repair/intersections/IntersectionClusters.h"
#include "mesh/repair/intersections/SolidUnion.h"
#include "mesh/structure/FaceComponents.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/PositionKey.h"
#include "mesh/structure/PositionTriangles.h"
#include "mesh/structure/Shells.h"
#include "tools/mesh/operations/MeshOperations.h"
#include "tools/mesh/repair/DefectFixChanges.h"

#include <QtGlobal>
#include <algorithm>
#include <limits>
#include <set>

namespace handwheel {
namespace {

constexpr const char* kOnlyWithHoles = QT_TRANSLATE_NOOP(
    "Tool", "no cut would separate the triangles cleanly; “Repair all” may replace them together with a hole");

bool hasHoles(const HalfEdgeMesh& mesh, Progress progress) {
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh, progress);
  return std::any_of(loops.begin(), loops.end(), [](const BoundaryLoop& loop) { return !loop.isSheetBoundary; });
}

// Without those that an undo has taken away meanwhile.
std::vector<Vertex> known(const HalfEdgeMesh& mesh, std::vector<Vertex> vertices) {
  std::erase_if(vertices, [&](Vertex v) { return v >= mesh.vertexSlots(); });
  return vertices;
}

std::vector<std::pair<Face, Face>> known(const HalfEdgeMesh& mesh, std::vector<std::pair<Face, Face>> pairs) {
  std::erase_if(pairs, [&](const auto& pair) { return std::max(pair.first, pair.second) >= mesh.faceSlots(); });
  return pairs;
}

bool partAllNonManifold(HalfEdgeMesh& mesh, NumberType numbers, Progress progress) {
  const bool done = separateNonManifold(mesh, numbers, {}, progress.part(0.0, 0.5));
  if (progress.cancelled()) return done;
  WorkBudget effort = progress.share(mostEffort(mesh));
  if (!separateTouchingVertices(mesh, numbers, progress.part(0.5, 0.9).within(effort)).empty())
    relink(mesh, progress.part(0.9, 1.0));
  return !effort.isSpent() && done;
}

// The faces of the components that have one of these vertices, by position.
FaceSelection componentsAt(const HalfEdgeMesh& mesh, const std::vector<Vertex>& vertices, Progress progress) {
  const PositionTriangles byPosition(mesh, progress.part(0.0, 0.5));
  if (progress.cancelled()) return {};
  const FaceComponents components(mesh, byPosition, progress.part(0.5, 1.0));
  if (progress.cancelled()) return {};
  const std::vector<std::uint32_t>& classOf = byPosition.classes.classOf;
  std::set<std::uint32_t> classes, wanted;
  for (const Vertex v : known(mesh, vertices)) classes.insert(classOf[v]);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (const Vertex v : mesh.triangle(f))
      if (classes.contains(classOf[v])) wanted.insert(components.of(f));
  }
  return FaceSelection::where(mesh.faceSlots(),
                              [&](Face f) { return mesh.isLive(f) && wanted.contains(components.of(f)); });
}

// Null for none, which is what removes all.
const FaceSelection* onlyOf(const FaceSelection& faces) {
  return faces.empty() ? nullptr : &faces;
}

}  // namespace

MeshChange degenerateFix(const FaceSelection& faces) {
  ScriptLineWriter step("degenerates");
  if (!faces.empty()) step.word(rangesText(faces));
  return asFix(
      {meshOperation("degenerates").title,
       [faces](HalfEdgeMesh& mesh, Progress progress) { removeDegenerateFaces(mesh, progress, onlyOf(faces)); }},
      step.text());
}

MeshChange duplicateFix(const FaceSelection& faces) {
  ScriptLineWriter step("duplicates");
  if (!faces.empty()) step.word(rangesText(faces));
  return asFix({meshOperation("duplicates").title,
                [faces](HalfEdgeMesh& mesh, Progress progress) { removeDuplicateFaces(mesh, progress, onlyOf(faces)); },
                kPlateSides},
               step.text());
}

MeshChange nearVertexFix(double nearWeld, std::vector<std::pair<Vertex, Vertex>> pairs) {
  ScriptLineWriter step("near-vertices");
  if (!pairs.empty()) step.word(pairsText(pairs));
  OperationValues values(meshOperation("near-vertices"));
  values.setValid("near-weld", nearWeld);
  step.options(values);
  return asFix({meshOperation("near-vertices").title,
                [nearWeld, pairs = std::move(pairs)](HalfEdgeMesh& mesh, Progress progress) {
                  std::vector<bool> fixed;
                  if (!pairs.empty()) fixed = fixedBut(mesh, pairs, nearWeld, progress.part(0.0, 0.4));
                  stitchBoundaries(mesh, fixed, progress.part(0.4, 1.0), nearWeld);
                },
                kMergesNothing},
               step.text());
}

MeshChange nonManifoldFix(NumberType numbers, std::vector<Vertex> vertices) {
  ScriptLineWriter step("split-nonmanifold");
  if (!vertices.empty()) step.word(listText(vertices));
  step.options(roundingValues("split-nonmanifold", numbers));
  return asFix(countedChange(
                   meshOperation("split-nonmanifold").title,
                   [numbers, vertices = std::move(vertices)](HalfEdgeMesh& mesh, Progress progress) {
                     if (vertices.empty()) return partAllNonManifold(mesh, numbers, progress);
                     const std::vector<Vertex> at = known(mesh, vertices);
                     return at.empty() || separateNonManifold(mesh, numbers, at, progress);
                   },
                   kNotSeparable),
               step.text());
}

MeshChange nonOrientableFix(const FillOptions& options, std::vector<Vertex> vertices) {
  ScriptLineWriter step("two-sides");
  if (!vertices.empty()) step.word(listText(vertices));
  step.options(fillingValues("two-sides", options));
  return asFix(countedChange(
                   meshOperation("two-sides").title,
                   [options, vertices = std::move(vertices)](HalfEdgeMesh& mesh, Progress progress) {
                     WorkBudget effort = progress.share(mostEffort(mesh));
                     const Progress now = progress.within(effort);
                     FaceSelection parts;
                     if (!vertices.empty()) parts = componentsAt(mesh, vertices, now.part(0.0, 0.05));
                     closeNonOrientable(mesh, options, std::numeric_limits<double>::infinity(), BoundaryCuts::Yes,
                                        now.part(0.05, 1.0), vertices.empty() ? nullptr : &parts);
                     return !effort.isSpent();
                   },
                   kNoCleanCut),
               step.text());
}

// A repair replaces what is folded around a hole, which no cut can separate.
MeshChange intersectionFix(NumberType numbers, std::vector<std::pair<Face, Face>> pairs) {
  ScriptLineWriter step("cut-crossings");
  step.word(pairsText(pairs)).options(roundingValues("cut-crossings", numbers));
  return asFix(explainedChange(
                   meshOperation("cut-crossings").title,
                   [numbers, pairs = std::move(pairs)](HalfEdgeMesh& mesh, Progress progress) {
                     WorkBudget effort = progress.share(mostEffort(mesh));
                     const ClusterRemoval cut =
                         removeClusterIntersections(mesh, known(mesh, pairs), numbers, progress.within(effort));
                     return cut.isCutShort ? kTooLong : hasHoles(mesh, progress) ? kOnlyWithHoles : nullptr;
                   },
                   kNoCleanSeparation),
               step.text());
}

MeshChange unionFix(NumberType numbers) {
  ScriptLineWriter step("unite");
  step.options(roundingValues("unite", numbers));
  return asFix(explainedChange(
                   meshOperation("unite").title,
                   [numbers](HalfEdgeMesh& mesh, Progress progress) {
                     WorkBudget effort = progress.share(mostEffort(mesh));
                     uniteSolids(mesh, numbers, progress.within(effort));
                     return effort.isSpent() ? kTooLong : nullptr;
                   },
                   kNoUnion),
               step.text());
}

MeshChange debrisFix(std::vector<Face> faces) {
  ScriptLineWriter step("debris");
  step.word(listText(faces));
  return asFix({meshOperation("debris").title,
                [faces = std::move(faces)](HalfEdgeMesh& mesh, Progress progress) {
                  FaceSelection pieces;
                  for (const Face f : faces) {
                    if (!mesh.isLive(f) || pieces.contains(f)) continue;
                    for (const Face other : sheetOf(mesh, f)) pieces.add(other);
                  }
                  removeFaces(mesh, pieces, progress);
                }},
               step.text());
}

MeshChange allDebrisFix() {
  return asFix(
      {meshOperation("debris").title, [](HalfEdgeMesh& mesh, Progress progress) { removeDebris(mesh, progress); },
       QT_TRANSLATE_NOOP("Tool", "no piece is far smaller than the largest")},
      "debris");
}

MeshChange insideOutFix() {
  return asFix(
      {meshOperation("reverse").title, [](HalfEdgeMesh& mesh, Progress progress) { orientOutward(mesh, progress); },
       QT_TRANSLATE_NOOP("Tool", "no body is inside out")},
      "reverse");
}

MeshChange orientFix(const FaceSelection& faces) {
  ScriptLineWriter step("orient");
  if (!faces.empty()) step.word(rangesText(faces));
  return asFix({meshOperation("orient").title,
                [faces](HalfEdgeMesh& mesh, Progress progress) {
                  FaceSelection turned = faces;
                  turned.dropDead(mesh);
                  if (faces.empty()) turned = FaceSelection(findInconsistentFaces(mesh, progress.part(0.0, 0.3)));
                  if (!turned.empty() && !progress.cancelled())
                    reverseFaces(mesh, turned.faces(), progress.part(0.3, 1.0));
                },
                QT_TRANSLATE_NOOP("Tool", "all neighbours agree already")},
               step.text());
}

MeshChange reverseChange(const FaceSelection& faces) {
  ScriptLineWriter step("reverse");
  step.word(rangesText(faces));
  return asFix({meshOperation("reverse").title,
                [faces](HalfEdgeMesh& mesh, Progress progress) {
                  const auto isChosen = [&](Face f) { return faces.contains(f); };
                  for (const std::vector<Face>& shell : findShells(mesh, progress)) {
                    if (progress.cancelled()) return;
                    if (std::any_of(shell.begin(), shell.end(), isChosen)) reverseShells(mesh, shell);
                  }
                }},
               step.text());
}

}  // namespace handwheel
