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
#include "mesh/structure/FaceComponents.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/PositionKey.h"
#include "mesh/structure/PositionTriangles.h"
#include "mesh/structure/Shells.h"
#include "tools/mesh/LoopText.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/MeshOperations.h"

#include <QtGlobal>
#include <algorithm>
#include <limits>
#include <set>

namespace handwheel {
namespace {

constexpr const char* kTooLong = QT_TRANSLATE_NOOP("Tool", "it would take too long for a mesh of this size");

// Why a sheet stays open; null where none does.
const char* whyOpen(const SheetOutcomes& sheets) {
  if (sheets.left.empty()) return nullptr;
  switch (sheets.left.rbegin()->first) {
    case FillFailure::SheetKeptOpen:
      return QT_TRANSLATE_NOOP("Tool", "a boundary of the sheet is marked to stay open, and a thin body has none");
    case FillFailure::SheetTooThin:
      return QT_TRANSLATE_NOOP("Tool", "the numbers of the file cannot show such a thickness");
    case FillFailure::TooMuchEffort:
      return kTooLong;
    default:
      return QT_TRANSLATE_NOOP("Tool", "however thin, the body would intersect the part");
  }
}

constexpr const char* kOnlyWithHoles = QT_TRANSLATE_NOOP(
    "Tool", "no cut would separate the triangles cleanly; “Repair all” may replace them together with a hole");

bool hasHoles(const HalfEdgeMesh& mesh, Progress progress) {
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh, progress);
  return std::any_of(loops.begin(), loops.end(), [](const BoundaryLoop& loop) { return !loop.rim; });
}

// A change that counts what it does. work: false where it was given up because that was too much.
MeshChange counted(const char* text, std::function<bool(HalfEdgeMesh&, Progress)> work, const char* reason) {
  return explainedChange(
      text, [work = std::move(work)](HalfEdgeMesh& mesh, Progress p) { return work(mesh, p) ? nullptr : kTooLong; },
      reason);
}

// Of trials.
std::size_t mostEffort(const HalfEdgeMesh& mesh, std::size_t fixed = tolerance::kObstructedHoleBudget) {
  return repairBudget(mesh.liveFaceCount(), 1.0, fixed);
}

std::vector<ObstructedHole> holesWith(const HalfEdgeMesh& mesh, const std::vector<Vertex>& keys, bool back,
                                      Progress progress) {
  std::vector<ObstructedHole> holes;
  for (BoundaryLoop& loop : findBoundaryLoops(mesh, progress)) {
    if (std::find(keys.begin(), keys.end(), keyOf(mesh, loop)) != keys.end()) holes.push_back({std::move(loop), back});
  }
  return holes;
}

bool isDone(const ObstructedClosings& closings) {
  return std::none_of(closings.holes.begin(), closings.holes.end(),
                      [](const ObstructedClosing& hole) { return hole.isCutShort; });
}

// thickness: of sheets that get a back.
ObstructedClosings closeHard(HalfEdgeMesh& mesh, const std::vector<ObstructedHole>& holes, const FillOptions& options,
                             double thickness, Progress progress) {
  WorkBudget effort = progress.share(mostEffort(mesh));
  return closeObstructedHoles(mesh, holes, options, thickness, progress.within(effort));
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

// Without those that an undo has taken away meanwhile.
std::vector<Vertex> known(const HalfEdgeMesh& mesh, std::vector<Vertex> vertices) {
  std::erase_if(vertices, [&](Vertex v) { return v >= mesh.vertexSlots(); });
  return vertices;
}

std::vector<std::pair<Face, Face>> known(const HalfEdgeMesh& mesh, std::vector<std::pair<Face, Face>> pairs) {
  std::erase_if(pairs, [&](const auto& pair) { return std::max(pair.first, pair.second) >= mesh.faceSlots(); });
  return pairs;
}

// at: as separateCoincidentVertices() has it.
bool partNonManifold(HalfEdgeMesh& mesh, NumberType numbers, const std::vector<Vertex>& at, Progress progress) {
  WorkBudget effort = progress.share(mostEffort(mesh));
  if (!separateCoincidentVertices(mesh, numbers, progress.part(0.0, 0.8).within(effort), {}, at).empty())
    relink(mesh, progress.part(0.8, 1.0));
  return !effort.isSpent();
}

bool partAllNonManifold(HalfEdgeMesh& mesh, NumberType numbers, Progress progress) {
  const bool done = partNonManifold(mesh, numbers, {}, progress.part(0.0, 0.5));
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

// Says before and after.
MeshChange fix(MeshChange change, std::string step) {
  change.isFix = true;
  return withStep(std::move(change), std::move(step));
}

}  // namespace

MeshChange degenerateFix(const FaceSelection& faces) {
  StepWriter step("degenerates");
  if (!faces.empty()) step.word(rangesText(faces));
  return fix({meshOperation("degenerates").title,
              [faces](HalfEdgeMesh& mesh, Progress progress) { removeDegenerateFaces(mesh, progress, onlyOf(faces)); }},
             step.text());
}

MeshChange duplicateFix(const FaceSelection& faces) {
  StepWriter step("duplicates");
  if (!faces.empty()) step.word(rangesText(faces));
  return fix({meshOperation("duplicates").title,
              [faces](HalfEdgeMesh& mesh, Progress progress) { removeDuplicateFaces(mesh, progress, onlyOf(faces)); },
              kPlateSides},
             step.text());
}

MeshChange nearVertexFix(double nearWeld, std::vector<std::pair<Vertex, Vertex>> pairs) {
  StepWriter step("near-vertices");
  if (!pairs.empty()) step.word(pairsText(pairs));
  OperationValues values(meshOperation("near-vertices"));
  values.setValid("near-weld", nearWeld);
  step.options(values);
  return fix({meshOperation("near-vertices").title,
              [nearWeld, pairs = std::move(pairs)](HalfEdgeMesh& mesh, Progress progress) {
                std::vector<bool> fixed;
                if (!pairs.empty()) fixed = fixedBut(mesh, pairs, nearWeld, progress.part(0.0, 0.4));
                stitchBorders(mesh, fixed, progress.part(0.4, 1.0), nearWeld);
              },
              kClosesNothing},
             step.text());
}

MeshChange nonManifoldFix(NumberType numbers, std::vector<Vertex> vertices) {
  StepWriter step("split-nonmanifold");
  if (!vertices.empty()) step.word(listText(vertices));
  step.options(rounding("split-nonmanifold", numbers));
  return fix(counted(
                 meshOperation("split-nonmanifold").title,
                 [numbers, vertices = std::move(vertices)](HalfEdgeMesh& mesh, Progress progress) {
                   if (vertices.empty()) return partAllNonManifold(mesh, numbers, progress);
                   const std::vector<Vertex> at = known(mesh, vertices);
                   return at.empty() || partNonManifold(mesh, numbers, at, progress);
                 },
                 kNotSeparable),
             step.text());
}

MeshChange nonOrientableFix(const FillOptions& options, std::vector<Vertex> vertices) {
  StepWriter step("two-sides");
  if (!vertices.empty()) step.word(listText(vertices));
  step.options(filling("two-sides", options));
  return fix(counted(
                 meshOperation("two-sides").title,
                 [options, vertices = std::move(vertices)](HalfEdgeMesh& mesh, Progress progress) {
                   WorkBudget effort = progress.share(mostEffort(mesh));
                   const Progress now = progress.within(effort);
                   FaceSelection parts;
                   if (!vertices.empty()) parts = componentsAt(mesh, vertices, now.part(0.0, 0.05));
                   closeNonOrientable(mesh, options, std::numeric_limits<double>::infinity(), BorderCuts::Yes,
                                      now.part(0.05, 1.0), vertices.empty() ? nullptr : &parts);
                   return !effort.isSpent();
                 },
                 kNoCleanCut),
             step.text());
}

// A repair replaces what is folded around a hole, which no cut can separate.
MeshChange intersectionFix(NumberType numbers, std::vector<std::pair<Face, Face>> pairs) {
  StepWriter step("cut-crossings");
  step.word(pairsText(pairs)).options(rounding("cut-crossings", numbers));
  return fix(explainedChange(
                 meshOperation("cut-crossings").title,
                 [numbers, pairs = std::move(pairs)](HalfEdgeMesh& mesh, Progress progress) {
                   WorkBudget effort = progress.share(mostEffort(mesh));
                   const ClusterRemoval cut =
                       removeClusterIntersections(mesh, known(mesh, pairs), numbers, progress.within(effort));
                   return cut.isCutShort ? kTooLong : hasHoles(mesh, progress) ? kOnlyWithHoles : nullptr;
                 },
                 QT_TRANSLATE_NOOP("Tool", "no cut would separate the triangles cleanly")),
             step.text());
}

MeshChange debrisFix(std::vector<Face> faces) {
  StepWriter step("debris");
  step.word(listText(faces));
  return fix({meshOperation("debris").title,
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
  return fix(
      {meshOperation("debris").title, [](HalfEdgeMesh& mesh, Progress progress) { removeDebris(mesh, progress); },
       QT_TRANSLATE_NOOP("Tool", "no piece is far smaller than the largest")},
      "debris");
}

MeshChange insideOutFix() {
  return fix(
      {meshOperation("reverse").title, [](HalfEdgeMesh& mesh, Progress progress) { orientOutward(mesh, progress); },
       QT_TRANSLATE_NOOP("Tool", "no body is inside out")},
      "reverse");
}

MeshChange reverseChange(const FaceSelection& faces) {
  StepWriter step("reverse");
  step.word(rangesText(faces));
  return fix({meshOperation("reverse").title,
              [faces](HalfEdgeMesh& mesh, Progress progress) {
                const auto isChosen = [&](Face f) { return faces.contains(f); };
                for (const std::vector<Face>& shell : findShells(mesh, progress)) {
                  if (progress.cancelled()) return;
                  if (std::any_of(shell.begin(), shell.end(), isChosen)) reverseShells(mesh, shell);
                }
              }},
             step.text());
}

MeshChange thickenFix(std::vector<Vertex> loops, const FillOptions& options, double thickness) {
  OperationValues values = filling("back", options);
  if (thickness > 0.0) values.setValid("thickness", thickness);
  StepWriter step("back");
  step.word(loopsText(loops)).options(values);
  const auto sheets = std::make_shared<SheetOutcomes>();
  const auto work = [loops = std::move(loops), options, thickness, sheets](HalfEdgeMesh& mesh, Progress progress) {
    const std::vector<ObstructedHole> holes = holesWith(mesh, loops, true, progress.part(0.0, 0.1));
    const double depth = thickness > 0.0 ? thickness : defaultSheetThickness(mesh);
    *sheets = closeHard(mesh, holes, options, depth, progress.part(0.1, 0.8)).sheets;
    bool done = true;
    if (!progress.cancelled()) done = partNonManifold(mesh, options.numbers, {}, progress.part(0.8, 1.0));
    return done ? whyOpen(*sheets) : kTooLong;
  };
  MeshChange change = explainedChange(meshOperation("back").title, work);
  change.sheets = sheets;
  return fix(std::move(change), step.text());
}

MeshChange cutAndCloseFix(Vertex loop, const FillOptions& options) {
  StepWriter step("cut-and-close");
  step.word(loopsText({loop})).options(filling("cut-and-close", options));
  return fix(counted(
                 meshOperation("cut-and-close").title,
                 [loop, options](HalfEdgeMesh& mesh, Progress progress) {
                   bool done = isDone(closeHard(mesh, holesWith(mesh, {loop}, false, progress.part(0.0, 0.1)), options,
                                                defaultSheetThickness(mesh), progress.part(0.1, 0.6)));
                   if (!progress.cancelled())
                     done = replaceFolded(mesh, loop, options, progress.part(0.6, 0.95)) && done;
                   if (!progress.cancelled())
                     done = partNonManifold(mesh, options.numbers, {}, progress.part(0.95, 1.0)) && done;
                   return done;
                 },
                 QT_TRANSLATE_NOOP("Tool", "the region to be cut is folded too much")),
             step.text());
}

}  // namespace handwheel
