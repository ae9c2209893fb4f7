// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/Suggestions.h"

#include "panels/defects/RepairSummary.h"
#include "panels/defects/StateCard.h"
#include "text/RepairText.h"
#include "theme/DefectKind.h"
#include "theme/Theme.h"
#include "window/mesh/MeshTab.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kReasonsNamed = 3;

struct SuggestionWords {
  Q_DECLARE_TR_FUNCTIONS(Suggestions)
};

// The possible defects besides holes. Faces reversed on opening are no defect any more.
constexpr DefectKind kFindings[] = {
    DefectKind::NonManifoldEdge, DefectKind::NonManifoldVertex, DefectKind::OneSided,
    DefectKind::InsideOut,       DefectKind::Inconsistent,      DefectKind::NearVertex,
    DefectKind::Degenerate,      DefectKind::Duplicate,         DefectKind::SelfIntersection,
    DefectKind::Debris,
};

QString sentence(const QStringList& parts) {
  return parts.isEmpty() ? QString() : parts.join(QStringLiteral(", ")) + QLatin1Char('.');
}

enum class Compared { No, Yes };

// "3 non-manifold edges, 1 piece of debris.": what is wrong besides the holes; without what comparison() says.
QString otherFindings(const DefectList& defectList, Compared compared) {
  QStringList parts;
  for (const DefectKind kind : kFindings) {
    const std::size_t n = defectList.count(kind);
    const bool isSaid = compared == Compared::Yes && defectList.countBefore(kind);
    if (n > 0 && !isSaid) parts << defectPhrase(kind, n);
  }
  return sentence(parts);
}

// "168 of 172 self-intersections removed, new: 2 non-manifold edges.": what the repair has changed.
QString comparison(const DefectList& defectList) {
  return sentence(defectSummary(defectList));
}

// "Hole 3 stays open: every patch would cross the part." for the first few.
QString reasons(const DefectList& defectList) {
  QStringList lines;
  int more = 0;
  for (int id : defectList.holes()) {
    const FillFailure failure = defectList.failure(id);
    if (failure == FillFailure::None || failure == FillFailure::WasSheetBoundary) continue;
    if (lines.size() == kReasonsNamed) {
      ++more;
    } else {
      lines << SuggestionWords::tr("%1 stays open: %2.").arg(defectList.loopName(id), fillFailureReason(failure));
    }
  }
  if (more > 0) lines << SuggestionWords::tr("…and %Ln more, see the list.", nullptr, more);
  return lines.join(QLatin1Char(' '));
}

QString formerSheets(const DefectList& defectList) {
  const auto& holes = defectList.holes();
  const auto former = static_cast<int>(std::count_if(
      holes.begin(), holes.end(), [&](int id) { return defectList.failure(id) == FillFailure::WasSheetBoundary; }));
  if (former == 0) return {};
  return SuggestionWords::tr(
             "Outer boundaries of open sheets that the repair changed and that look like holes now: %1. "
             "Another repair tries to fill them.")
      .arg(QLocale().toString(former));
}

// "Self-intersections stay: no cut would separate the triangles cleanly.", where a fix of all of them was tried.
QString failedFixes(const DefectList& defectList) {
  if (defectList.count(DefectKind::SelfIntersection) == 0 || !defectList.isHopeless(DefectKind::SelfIntersection))
    return {};
  return SuggestionWords::tr("The self-intersections stay: %1.")
      .arg(defectList.reason(DefectKind::SelfIntersection, -1));
}

// Returns true if there is a sheet that no attempt has failed to thicken.
bool hasSheetToThicken(const DefectList& defectList) {
  const auto& open = defectList.keptOpen();
  return std::any_of(open.begin(), open.end(), [&](int id) {
    const FillFailure failure = defectList.failure(id);
    return defectList.loop(id).isSheetBoundary &&
           (failure == FillFailure::None || failure == FillFailure::SheetBoundary ||
            failure == FillFailure::SheetKeptOpen);
  });
}

QString openTitle(const DefectList& defectList) {
  const auto sheets = static_cast<int>(defectList.sheetCount());
  const auto pieces = static_cast<int>(defectList.state().components);
  if (defectList.keptOpen().size() > defectList.sheetCount())
    return SuggestionWords::tr("No holes remain except those kept open.");
  if (sheets == 0) return SuggestionWords::tr("No holes.");
  if (pieces == 1) return SuggestionWords::tr("No holes. This is an open sheet.");
  return sheets == pieces ? SuggestionWords::tr("No holes. These are %Ln open sheet(s).", nullptr, sheets)
                          : SuggestionWords::tr("No holes. %Ln open sheet(s) among %1 pieces.", nullptr, sheets)
                                .arg(QLocale().toString(pieces));
}

// With nothing wrong but that it is open, on purpose or as a sheet.
bool isOnlyOpen(const DefectList& defectList) {
  const MeshState state = defectList.state();
  return defectList.holes().empty() && !state.closed && state.manifold && state.oriented &&
         state.selfIntersectingPairs.value_or(0) == 0;
}

// In the words of the panel, but for what is open.
QString headline(const DefectList& defectList) {
  const auto holes = static_cast<int>(defectList.count(DefectKind::Hole));
  if (holes > 0) return SuggestionWords::tr("%Ln hole(s) found.", nullptr, holes);
  if (isOnlyOpen(defectList)) return openTitle(defectList);
  const MeshState state = defectList.state();
  if (state.isSound() && !state.isKnownSound()) return SuggestionWords::tr("Closed. Looking for self-intersections…");
  return stateHeadline(defectList) + QLatin1Char('.');
}

// Solids in solids print as they look from outside, but count twice, and slicers differ.
QString nestedBodies(const MeshTab& document) {
  const auto nested = static_cast<int>(document.document.defects().nestedBodies);
  return nested == 0 ? QString()
                     : SuggestionWords::tr("%Ln body(ies) inside another: “Unite bodies” removes what lies inside.",
                                           nullptr, nested);
}

// For texts whose headline does not name them.
QString openSheets(const DefectList& defectList) {
  const auto sheets = static_cast<int>(defectList.sheetCount());
  return sheets == 0 || isOnlyOpen(defectList) ? QString() : SuggestionWords::tr("%Ln open sheet(s).", nullptr, sheets);
}

bool isWorthSaving(const MeshTab& document) {
  return document.document.isModified() || (!document.written && !document.document.reversedFaces().empty());
}

// Once all of it is in the file.
QString savedAs(const MeshTab& document) {
  if (!document.written || isWorthSaving(document)) return {};
  return SuggestionWords::tr("Saved as %1.").arg(document.document.name());
}

QString joined(QStringList sentences) {
  sentences.removeAll(QString());
  return sentences.join(QLatin1Char(' '));
}

// Returns true if a defect is left after the repair of triangles that a repair by volume mends.
bool needsVolume(const DefectList& defectList) {
  const MeshState state = defectList.state();
  return defectList.count(DefectKind::SelfIntersection) > 0 || defectList.count(DefectKind::Hole) > 0 ||
         !state.manifold || !state.oriented;
}

// Adds the actions for defects that a repair leaves, except for those tried in vain. None of them is what most people
// want: the card shows no such action as the obvious one.
void addFurther(Suggestion& step, const MeshTab& document, const SuggestedActions& actions) {
  const DefectList& defectList = document.defectList;
  step.isFirstObvious = !step.actions.empty();
  if (hasSheetToThicken(defectList) && actions.thickenSheet->isEnabled()) step.actions.push_back(actions.thickenSheet);
  if (defectList.count(DefectKind::InsideOut) > 0) step.actions.push_back(actions.reverseBodies);
  if (defectList.count(DefectKind::SelfIntersection) > 0 && !defectList.isHopeless(DefectKind::SelfIntersection))
    step.actions.push_back(actions.resolveIntersections);
  if (actions.uniteBodies->isEnabled()) step.actions.push_back(actions.uniteBodies);
  if (needsVolume(defectList)) step.actions.push_back(actions.repairByVolume);
  if (!defectList.debris().empty()) step.actions.push_back(actions.removeDebris);
  if (actions.showDefects) step.actions.push_back(actions.showDefects);
  if (document.isJustRepaired() && document.document.isModified()) step.actions.push_back(actions.undoRepair);
}

// The card must not cover the part: of many warnings it has the first ones.
QStringList shownWarnings(const DefectList& defectList) {
  constexpr int kMostShown = 2;
  QStringList warnings = defectList.patchWarnings();
  if (!defectList.removalWarning().isEmpty()) warnings.prepend(defectList.removalWarning());
  const auto more = static_cast<int>(warnings.size()) - kMostShown;
  if (more < 2) return warnings;
  warnings = warnings.mid(0, kMostShown);
  return warnings << SuggestionWords::tr("…and %Ln more, see the log.", nullptr, more);
}

// Returns the step for a mesh that is closed, or kept open, with no other defect that "Repair all" mends.
Suggestion cleanStep(const MeshTab& document, const SuggestedActions& actions) {
  const DefectList& defectList = document.defectList;
  const ThemeColours& colours = themeColours(currentTheme());
  const MeshState state = defectList.state();
  Suggestion step{
      defectIconName(DefectKind::KeptOpen), defectColour(DefectKind::KeptOpen), headline(defectList), {}, {}};
  if (state.isSound()) {
    step.icon = QStringLiteral("watertight");
    step.colour = state.isKnownSound() ? colours.success : colours.muted;
  } else if (state.selfIntersectingPairs.value_or(0) > 0) {
    step.icon = QStringLiteral("warning");
    step.colour = colours.warning;
  }
  QStringList details = shownWarnings(defectList);
  const auto turned = static_cast<int>(document.document.reversedFaces().size());
  if (isWorthSaving(document)) {
    details << comparison(defectList) << otherFindings(defectList, Compared::Yes);
    step.actions.push_back(actions.saveAs);
    if (turned > 0) details << SuggestionWords::tr("%Ln triangle(s) reversed on opening.", nullptr, turned);
  } else {
    details << otherFindings(defectList, Compared::No) << savedAs(document);
    if (!document.written && state.isKnownSound() && defectList.debris().empty() &&
        document.document.defects().nestedBodies == 0)
      details << SuggestionWords::tr("There is nothing to repair.");
  }
  details << openSheets(defectList) << nestedBodies(document) << failedFixes(defectList);
  step.detail = joined(details);
  addFurther(step, document, actions);
  return step;
}

// After a repair that left something.
Suggestion leftStep(const MeshTab& document, const SuggestedActions& actions) {
  const DefectList& defectList = document.defectList;
  // The same number as in the summary, where a hole that was left in pieces counts once.
  const std::size_t failed = defectList.loopOutcomes().holes.failed;
  const auto holes = static_cast<int>(failed > 0 ? failed : defectList.count(DefectKind::Hole));
  Suggestion left{QStringLiteral("warning"),
                  themeColours(currentTheme()).warning,
                  failed > 0  ? SuggestionWords::tr("%Ln hole(s) could not be filled.", nullptr, holes)
                  : holes > 0 ? SuggestionWords::tr("%Ln hole(s) left.", nullptr, holes)
                              : SuggestionWords::tr("Some defects remain."),
                  joined({shownWarnings(defectList).join(QLatin1Char(' ')), comparison(defectList), reasons(defectList),
                          formerSheets(defectList), failedFixes(defectList), openSheets(defectList),
                          nestedBodies(document), otherFindings(defectList, Compared::Yes), savedAs(document)}),
                  {}};
  if (holes > 0 && failed == 0) left.actions.push_back(actions.repairAll);
  if (holes > 0) left.actions.push_back(actions.oneByOne);
  if (isWorthSaving(document)) left.actions.push_back(actions.saveAs);
  addFurther(left, document, actions);
  return left;
}

}  // namespace

Suggestion suggestionFor(const MeshTab& document, const SuggestedActions& actions) {
  const DefectList& defectList = document.defectList;
  if (document.cardDismissed) return {};
  if (defectList.isClean()) return cleanStep(document, actions);
  // Not once that is undone, or anything else was changed: then it may do something.
  if (document.isRepaired()) return leftStep(document, actions);
  const bool holes = !defectList.holes().empty();
  const QString changes = comparison(defectList);
  Suggestion step{
      holes ? defectIconName(DefectKind::Hole) : QStringLiteral("warning"),
      holes ? defectColour(DefectKind::Hole) : themeColours(currentTheme()).warning,
      headline(defectList),
      joined({changes, openSheets(defectList), nestedBodies(document),
              otherFindings(defectList, changes.isEmpty() ? Compared::No : Compared::Yes), savedAs(document)}),
      {actions.repairAll}};
  if (holes) step.actions.push_back(actions.oneByOne);
  if (actions.uniteBodies->isEnabled()) step.actions.push_back(actions.uniteBodies);
  // Also after an undo: a repair of the triangles has left something once.
  if (document.repairedAt && needsVolume(defectList)) step.actions.push_back(actions.repairByVolume);
  if (actions.showDefects) step.actions.push_back(actions.showDefects);
  return step;
}

}  // namespace handwheel
