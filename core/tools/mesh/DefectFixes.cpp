// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/DefectFixes.h"

#include "mesh/boundary/Stitching.h"
#include "mesh/defects/Defects.h"
#include "mesh/defects/DuplicateFaces.h"
#include "mesh/defects/InsideOutShells.h"
#include "mesh/repair/Cleaning.h"
#include "mesh/repair/CoincidentVertexSeparation.h"
#include "mesh/repair/FoldedRegionRemoval.h"
#include "mesh/repair/IntersectionClusters.h"
#include "mesh/repair/NonOrientableSurfaces.h"
#include "mesh/repair/ObstructedHoles.h"
#include "mesh/repair/RepairBudget.h"
#include "mesh/repair/SheetThickening.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/Shells.h"
#include "proximity/ExactOrientation.h"
#include "tools/mesh/LoopText.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/MeshOperations.h"

#include <QtGlobal>
#include <algorithm>
#include <limits>

namespace handwheel {
namespace {

constexpr const char* kTooLong = QT_TRANSLATE_NOOP("Tool", "it would take too long for a mesh of this size");

// A change that counts what it does. work: false where it was given up because that was too much.
MeshChange counted(const char* text, std::function<bool(HalfEdgeMesh&, Progress)> work, const char* reason) {
  auto found = std::make_shared<std::atomic<const char*>>(nullptr);
  MeshChange change{text,
                    [work = std::move(work), found](HalfEdgeMesh& mesh, Progress progress) {
                      *found = work(mesh, progress) ? nullptr : kTooLong;
                    },
                    reason};
  change.found = std::move(found);
  return change;
}

// Of trials.
std::size_t mostEffort(const HalfEdgeMesh& mesh, std::size_t fixed = tolerance::kObstructedHoleBudget) {
  return repairBudget(mesh.liveFaceCount(), 1.0, fixed);
}

bool closeHard(HalfEdgeMesh& mesh, const std::vector<Vertex>& keys, bool back, const FillOptions& options,
               Progress progress) {
  std::vector<ObstructedHole> holes;
  for (BoundaryLoop& loop : findBoundaryLoops(mesh, progress.part(0.0, 0.1))) {
    if (std::find(keys.begin(), keys.end(), keyOf(mesh, loop)) != keys.end()) holes.push_back({std::move(loop), back});
  }
  WorkBudget effort = progress.share(mostEffort(mesh));
  const ObstructedClosings closings = closeObstructedHoles(
      mesh, holes, options, tolerance::kSheetThickness * diagonalOf(mesh), progress.part(0.1, 1.0).within(effort));
  return std::none_of(closings.holes.begin(), closings.holes.end(),
                      [](const ObstructedClosing& hole) { return hole.isCutShort; });
}

bool replaceFolded(HalfEdgeMesh& mesh, Vertex key, const FillOptions& options, Progress progress) {
  std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh, progress.part(0.0, 0.1));
  std::erase_if(loops, [&](const BoundaryLoop& loop) { return keyOf(mesh, loop) != key; });
  WorkBudget effort = progress.share(mostEffort(mesh, tolerance::kFoldedRegionBudget));
  replaceFoldedRegions(mesh, loops, options, progress.part(0.1, 1.0).within(effort));
  return !effort.isSpent();
}

// The operation with these options of a fill, or number type.
OperationValues filling(const char* verb, const FillOptions& options) {
  OperationValues values(meshOperation(verb));
  setFillOptions(values, options);
  return values;
}

OperationValues rounding(const char* verb, NumberType numbers) {
  OperationValues values(meshOperation(verb));
  setNumbers(values, numbers);
  return values;
}

bool partNonManifold(HalfEdgeMesh& mesh, NumberType numbers, Progress progress) {
  WorkBudget effort = progress.share(mostEffort(mesh));
  if (!separateCoincidentVertices(mesh, numbers, progress.part(0.0, 0.8).within(effort)).empty())
    relink(mesh, progress.part(0.8, 1.0));
  return !effort.isSpent();
}

bool areCoplanar(const HalfEdgeMesh& mesh, const std::pair<Face, Face>& pair) {
  if (!mesh.isProper(pair.first) || !mesh.isProper(pair.second)) return false;
  const auto at = [&](Face f, std::size_t k) -> const Vec3& { return mesh.position(mesh.triangle(f)[k]); };
  const ExactPlane plane(at(pair.first, 0), at(pair.first, 1), at(pair.first, 2));
  return plane.side(at(pair.second, 0)) == 0 && plane.side(at(pair.second, 1)) == 0 &&
         plane.side(at(pair.second, 2)) == 0;
}

// Why intersecting triangles stay as they are, where cutting changes nothing.
const char* reasonNotToCut(const HalfEdgeMesh& mesh, const std::vector<std::pair<Face, Face>>& pairs) {
  const bool isAnyFlat =
      std::any_of(pairs.begin(), pairs.end(), [&mesh](const auto& pair) { return areCoplanar(mesh, pair); });
  return isAnyFlat ? QT_TRANSLATE_NOOP("Tool", "some of the triangles are coplanar, and no cut separates those")
                   : QT_TRANSLATE_NOOP("Tool", "no cut would separate the triangles cleanly");
}

}  // namespace

MeshChange degenerateFix() {
  return withStep({meshOperation("degenerates").title,
                   [](HalfEdgeMesh& mesh, Progress progress) { removeDegenerateFaces(mesh, progress); }},
                  "degenerates");
}

MeshChange duplicateFix() {
  return withStep({meshOperation("duplicates").title,
                   [](HalfEdgeMesh& mesh, Progress progress) { removeDuplicateFaces(mesh, progress); },
                   QT_TRANSLATE_NOOP("Tool", "they are the two sides of a plate of zero thickness, which is closed")},
                  "duplicates");
}

MeshChange nearVertexFix(double nearWeld, std::vector<std::pair<Vertex, Vertex>> pairs) {
  StepWriter step("near-vertices");
  if (!pairs.empty()) step.word(pairsText(pairs));
  OperationValues values(meshOperation("near-vertices"));
  values.setValid("near-weld", nearWeld);
  step.options(values);
  return withStep({meshOperation("near-vertices").title,
                   [nearWeld, pairs = std::move(pairs)](HalfEdgeMesh& mesh, Progress progress) {
                     std::vector<bool> fixed(mesh.vertexSlots(), !pairs.empty());
                     for (const auto& [a, b] : pairs) fixed[a] = fixed[b] = false;
                     stitchBorders(mesh, fixed, progress, nearWeld);
                   },
                   QT_TRANSLATE_NOOP("Tool", "merging them would not close the surface any further")},
                  step.text());
}

MeshChange nonManifoldFix(NumberType numbers) {
  return withStep(
      counted(
          meshOperation("split-nonmanifold").title,
          [numbers](HalfEdgeMesh& mesh, Progress progress) { return partNonManifold(mesh, numbers, progress); },
          QT_TRANSLATE_NOOP("Tool", "every separation would make the surface intersect itself")),
      StepWriter("split-nonmanifold").options(rounding("split-nonmanifold", numbers)).text());
}

MeshChange nonOrientableFix(const FillOptions& options) {
  StepWriter step("two-sides");
  step.options(filling("two-sides", options));
  return withStep(counted(
                      meshOperation("two-sides").title,
                      [options](HalfEdgeMesh& mesh, Progress progress) {
                        WorkBudget effort = progress.share(mostEffort(mesh));
                        closeNonOrientable(mesh, options, std::numeric_limits<double>::infinity(), BorderCuts::Yes,
                                           progress.within(effort));
                        return !effort.isSpent();
                      },
                      QT_TRANSLATE_NOOP("Tool", "the cut could not be closed without intersecting the part")),
                  step.text());
}

MeshChange intersectionFix(NumberType numbers, std::vector<std::pair<Face, Face>> pairs) {
  StepWriter step("cut-crossings");
  step.word(pairsText(pairs)).options(rounding("cut-crossings", numbers));
  auto found = std::make_shared<std::atomic<const char*>>(nullptr);
  MeshChange change{meshOperation("cut-crossings").title,
                    [numbers, pairs = std::move(pairs), found](HalfEdgeMesh& mesh, Progress progress) {
                      const char* const ifNone = reasonNotToCut(mesh, pairs);
                      WorkBudget effort = progress.share(mostEffort(mesh));
                      *found = removeClusterIntersections(mesh, pairs, numbers, progress.within(effort)).isCutShort
                                   ? kTooLong
                                   : ifNone;
                    }};
  change.found = std::move(found);
  return withStep(std::move(change), step.text());
}

MeshChange debrisFix(std::vector<Face> faces) {
  StepWriter step("debris");
  step.word(listText(faces));
  return withStep({meshOperation("debris").title,
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
  return withStep(
      {meshOperation("debris").title, [](HalfEdgeMesh& mesh, Progress progress) { removeDebris(mesh, progress); },
       QT_TRANSLATE_NOOP("Tool", "no piece is far smaller than the largest")},
      "debris");
}

MeshChange insideOutFix() {
  return withStep(
      {meshOperation("reverse").title, [](HalfEdgeMesh& mesh, Progress progress) { orientOutward(mesh, progress); },
       QT_TRANSLATE_NOOP("Tool", "no closed surface is inside out")},
      "reverse");
}

MeshChange reverseChange(const FaceSelection& faces) {
  StepWriter step("reverse");
  step.word(rangesText(faces));
  return withStep({meshOperation("reverse").title,
                   [faces](HalfEdgeMesh& mesh, Progress progress) {
                     const auto isChosen = [&](Face f) { return faces.contains(f); };
                     for (const std::vector<Face>& shell : findShells(mesh, progress)) {
                       if (progress.cancelled()) return;
                       if (std::any_of(shell.begin(), shell.end(), isChosen)) reverseShells(mesh, shell);
                     }
                   }},
                  step.text());
}

MeshChange thickenFix(std::vector<Vertex> loops, const FillOptions& options) {
  StepWriter step("back");
  step.word(loopsText(loops)).options(filling("back", options));
  return withStep(
      counted(
          meshOperation("back").title,
          [loops = std::move(loops), options](HalfEdgeMesh& mesh, Progress progress) {
            const bool closed = closeHard(mesh, loops, true, options, progress);
            const bool parted = progress.cancelled() || partNonManifold(mesh, options.numbers, progress);
            return closed && parted;
          },
          QT_TRANSLATE_NOOP("Tool", "thickening would intersect the part, or close a hole that is kept open")),
      step.text());
}

MeshChange cutAndCloseFix(Vertex loop, const FillOptions& options) {
  StepWriter step("cut-and-close");
  step.word(loopsText({loop})).options(filling("cut-and-close", options));
  return withStep(counted(
                      meshOperation("cut-and-close").title,
                      [loop, options](HalfEdgeMesh& mesh, Progress progress) {
                        bool done = closeHard(mesh, {loop}, false, options, progress.part(0.0, 0.6));
                        if (!progress.cancelled())
                          done = replaceFolded(mesh, loop, options, progress.part(0.6, 0.95)) && done;
                        if (!progress.cancelled())
                          done = partNonManifold(mesh, options.numbers, progress.part(0.95, 1.0)) && done;
                        return done;
                      },
                      QT_TRANSLATE_NOOP("Tool", "the region to be cut is folded too much")),
                  step.text());
}

}  // namespace handwheel
