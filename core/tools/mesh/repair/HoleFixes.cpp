// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/repair/HoleFixes.h"

#include "mesh/repair/ObstructedHoles.h"
#include "mesh/repair/SheetThickening.h"
#include "mesh/repair/intersections/FoldedRegionRemoval.h"
#include "tools/mesh/BoundaryLoopText.h"
#include "tools/mesh/operations/MeshOperations.h"
#include "tools/mesh/repair/DefectFixChanges.h"

#include <algorithm>

namespace handwheel {
namespace {

// Returns the reason why a sheet stays open; null if none does.
const char* whyOpen(const SheetOutcomes& sheets) {
  if (sheets.left.empty()) return nullptr;
  switch (sheets.left.rbegin()->first) {
    case FillFailure::SheetKeptOpen:
      return QT_TRANSLATE_NOOP("Tool", "a boundary of the sheet is marked to stay open, and a thin body has none");
    case FillFailure::SheetTooThin:
      return QT_TRANSLATE_NOOP("Tool", "the numbers of the file cannot show such a thickness");
    case FillFailure::TooMuchEffort:
      return QT_TRANSLATE_NOOP("Tool",
                               "it would take too long for a mesh of this size; “handwheel voxelize --wall” makes a "
                               "volume with walls of any sheets");
    default:
      return QT_TRANSLATE_NOOP("Tool", "however thin, the body would intersect the part");
  }
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

}  // namespace

MeshChange thickenFix(std::vector<Vertex> loops, const FillOptions& options, double thickness) {
  OperationValues values = fillingValues("back", options);
  if (thickness > 0.0) values.setValid("thickness", thickness);
  ScriptLineWriter step("back");
  step.word(loopsText(loops)).options(values);
  const auto sheets = std::make_shared<SheetOutcomes>();
  const auto work = [loops = std::move(loops), options, thickness, sheets](HalfEdgeMesh& mesh, Progress progress) {
    const std::vector<ObstructedHole> holes = holesWith(mesh, loops, true, progress.part(0.0, 0.1));
    const double depth = thickness > 0.0 ? thickness : defaultSheetThickness(mesh);
    *sheets = closeHard(mesh, holes, options, depth, progress.part(0.1, 0.8)).sheets;
    bool done = true;
    if (!progress.cancelled()) done = separateNonManifold(mesh, options.numbers, {}, progress.part(0.8, 1.0));
    const char* why = whyOpen(*sheets);
    return done || why ? why : kTooLong;
  };
  MeshChange change = explainedChange(meshOperation("back").title, work);
  change.sheets = sheets;
  return asFix(std::move(change), step.text());
}

MeshChange cutAndCloseFix(Vertex loop, const FillOptions& options) {
  ScriptLineWriter step("cut-and-close");
  step.word(loopsText({loop})).options(fillingValues("cut-and-close", options));
  return asFix(countedChange(
                   meshOperation("cut-and-close").title,
                   [loop, options](HalfEdgeMesh& mesh, Progress progress) {
                     bool done = isDone(closeHard(mesh, holesWith(mesh, {loop}, false, progress.part(0.0, 0.1)),
                                                  options, defaultSheetThickness(mesh), progress.part(0.1, 0.6)));
                     if (!progress.cancelled())
                       done = replaceFolded(mesh, loop, options, progress.part(0.6, 0.95)) && done;
                     if (!progress.cancelled())
                       done = separateNonManifold(mesh, options.numbers, {}, progress.part(0.95, 1.0)) && done;
                     return done;
                   },
                   QT_TRANSLATE_NOOP("Tool", "the region to be cut is folded too much")),
               step.text());
}

}  // namespace handwheel
