// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Wording.h"

#include "cli/Messages.h"
#include "mesh/boundary/LoopNumbers.h"
#include "text/RepairText.h"

#include <algorithm>

namespace handwheel {

namespace {

std::string counted(std::size_t n, std::string_view one, std::string_view many) {
  return std::to_string(n) + " " + std::string(n == 1 ? one : many);
}

// Returns the names in the window and in 'handwheel inspect', by id.
std::vector<std::string> namesOf(const std::vector<LoopResult>& loops) {
  LoopNumbers numbers;
  std::vector<std::string> names;
  for (const LoopResult& loop : loops)
    names.push_back(loop.id < 0
                        ? "A hole opened by the repair"
                        : boundaryLoopName(loop.isSheetBoundary, numbers.take(loop.isSheetBoundary)).toStdString());
  return names;
}

// Returns "id 3, ", the id for --keep-open, the steps and the report; empty if the loop is not one of the input.
std::string idOf(const LoopResult& loop) {
  return loop.id < 0 ? std::string() : "id " + std::to_string(loop.id) + ", ";
}

std::string leftOpen(const LoopResult& loop, const std::string& name) {
  return name + " (" + idOf(loop) + counted(loop.edges, "edge", "edges") +
         ") stays open: " + fillFailureReason(loop.reason).toStdString() + ".";
}

// Returns a sentence if the work was cut short; empty if all of it was done.
std::string cutShort(bool isCutShort, const std::string& what) {
  if (!isCutShort) return {};
  return " " + what + " is incomplete: " + fillFailureReason(FillFailure::TooMuchEffort).toStdString() + ".";
}

// Returns the advice to use --cut-crossings, unless it was given.
std::string adviceOnCrossings(const RepairReport& repair, const RepairOptions& options) {
  if (!options.resolvesIntersections()) return " --cut-crossings resolves them where possible.";
  if (repair.isIntersectionRemovalIncomplete) return cutShort(true, "Cutting");
  return " --cut-crossings found no cut that would separate these cleanly.";
}

}  // namespace

std::string wordFor(LoopOutcome outcome) {
  switch (outcome) {
    case LoopOutcome::Filled:
      return "filled";
    case LoopOutcome::KeptOpen:
      return "kept-open";
    case LoopOutcome::Failed:
      return "failed";
  }
  return {};
}

std::string wordFor(Substitute substitute) {
  switch (substitute) {
    case Substitute::None:
      return "none";
    case Substitute::LessSmooth:
      return "less-smooth";
    case Substitute::OtherMethod:
      return "other-method";
  }
  return {};
}

std::string outcomesText(const LoopCounts& loops) {
  QStringList parts = outcomeTexts(loops);
  if (loops.holes.all == 0) parts.prepend(QStringLiteral("No holes"));
  return parts.join(QStringLiteral(", ")).toStdString();
}

std::string reasonSentence(FillFailure failure) {
  const QString reason = fillFailureReason(failure);
  return (reason.left(1).toUpper() + reason.mid(1) + '.').toStdString();
}

std::vector<std::string> repairWarnings(const RepairReport& repair) {
  constexpr std::size_t kMostLines = 10;
  std::vector<std::string> lines;
  if (repair.removed) lines.push_back(removalWarning(*repair.removed, LengthUnit::Millimetre).toStdString());
  std::size_t more = 0;
  const std::vector<std::string> names = namesOf(repair.loops);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const LoopResult& loop = repair.loops[i];
    const QString warning = loop.outcome == LoopOutcome::Filled ? patchWarning(loop.shape) : QString();
    if (!warning.isEmpty() && lines.size() >= kMostLines)
      ++more;
    else if (!warning.isEmpty())
      lines.push_back(names[i] + " (" + idOf(loop) + counted(loop.edges, "edge", "edges") +
                      "): check its patch: " + warning.toStdString() + ".");
  }
  if (more > 0)
    lines.push_back("Check " + counted(more, "further patch", "further patches") +
                    ", too: --report FILE has the bends of all.");
  return lines;
}

std::vector<std::string> damageSentences(const DocumentFile& file) {
  std::vector<std::string> sentences;
  for (const Error& error : file.damage) sentences.push_back(sentenceFor(error));
  if (file.unlistedDamage > 0) {
    sentences.push_back("Damage at " + counted(file.unlistedDamage, "further place", "further places") + ".");
  }
  return sentences;
}

std::string changesLine(const RepairReport& repair) {
  const QString changes = repairSummary(repair).join(", ");
  return changes.isEmpty() ? std::string() : "Also: " + changes.toStdString() + ".\n";
}

std::vector<std::string> leftovers(const RepairReport& repair, const RepairOptions& options, const MeshReport& before,
                                   const MeshReport& after) {
  std::vector<std::string> lines;
  std::size_t sheets = 0, formerSheets = 0;
  const std::vector<std::string> names = namesOf(repair.loops);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const LoopResult& loop = repair.loops[i];
    const bool isOpen = loop.outcome != LoopOutcome::Filled;
    if (isOpen && loop.reason == FillFailure::SheetBoundary) {
      ++sheets;
    } else if (isOpen && loop.reason == FillFailure::WasSheetBoundary) {
      ++formerSheets;
    } else if (isOpen) {
      lines.push_back(leftOpen(loop, names[i]));
    }
  }
  const bool areAllFormer = lines.empty();  // the holes of the result
  if (sheets > 0) {
    lines.push_back(counted(sheets, "outer boundary of an open sheet stays", "outer boundaries of open sheets stay") +
                    " open. --open-sheets back thickens the sheets to thin bodies, --open-sheets fill closes the "
                    "boundaries as holes.");
  }
  if (formerSheets > 0) {
    const bool isOne = formerSheets == 1;
    const auto holesNow = static_cast<std::size_t>(std::count_if(
        after.loops.begin(), after.loops.end(), [](const LoopReport& loop) { return !loop.isSheetBoundary; }));
    lines.push_back(
        counted(formerSheets, "outer boundary of an open sheet", "outer boundaries of open sheets") +
        ", which the repair has changed, " + (isOne ? "looks like a hole" : "look like holes") + " now" +
        (areAllFormer && holesNow != formerSheets ? ", " + std::to_string(holesNow) + " in the result," : "") +
        " and " + (isOne ? "stays" : "stay") + " open. Another repair would try to fill " + (isOne ? "it." : "them."));
  }
  if (lines.empty() && after.boundaryEdges > 0) {
    lines.push_back(counted(after.boundaryEdges, "edge has", "edges have") + " only one triangle.");
  }
  if (after.nonManifoldEdges > 0) {
    lines.push_back(counted(after.nonManifoldEdges, "edge has", "edges have") + " more than two triangles." +
                    cutShort(repair.isSeparationIncomplete, "Separating touching parts"));
  }
  if (after.inconsistentEdges > 0) {
    lines.push_back("At " + counted(after.inconsistentEdges, "edge", "edges") +
                    " the adjacent triangles have inconsistent orientation.");
  }
  if (after.insideOutBodies > 0) {
    lines.push_back(counted(after.insideOutBodies, "body is", "bodies are") +
                    " inside out; 'handwheel edit' with the step reverse reverses them.");
  }
  if (after.nonManifoldVertices > 0) {
    lines.push_back("At " + counted(after.nonManifoldVertices, "vertex", "vertices") +
                    " triangles touch that share no edge.");
  }
  if (const std::size_t pairs = after.selfIntersectingPairs.value_or(0); pairs > 0) {
    lines.push_back("The surface intersects itself: " + counted(pairs, "pair", "pairs") +
                    " of triangles intersect or overlap." + adviceOnCrossings(repair, options));
  }
  if (options.uniteSolids && repair.innerFaces == 0 && !repair.isIntersectionRemovalIncomplete)
    lines.push_back(
        "No bodies were united: they must intersect or share a wall, be closed and not inside out, and the numbers of "
        "the file must be able to hold the cuts.");
  if (after.nestedBodies > 0) {
    lines.push_back(counted(after.nestedBodies, "body lies", "bodies lie") +
                    " inside another; --unite removes what lies inside.");
  }
  if (after.debris > before.debris) {
    lines.push_back("New: " + counted(after.debris - before.debris, "piece", "pieces") + " of debris, " +
                    std::to_string(after.debris) + " in all. Another repair with --remove-debris removes them.");
  }
  const bool isCut = options.resolvesIntersections() && after.selfIntersectingPairs.value_or(0) > 0;
  if (after.nonManifoldEdges > 0 || after.nonManifoldVertices > 0 || isCut)
    lines.push_back("--by volume makes a surface without such places, in the detail of its voxels.");
  return lines;
}

}  // namespace handwheel
