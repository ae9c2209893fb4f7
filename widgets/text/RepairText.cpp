// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/RepairText.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

struct RepairWords {
  Q_DECLARE_TR_FUNCTIONS(RepairText)
};

int asInt(std::size_t n) {
  return static_cast<int>(std::min<std::size_t>(n, std::numeric_limits<int>::max()));
}

// Formats with three significant digits, or as a whole number; with an exponent instead of too many zeros.
QString significantText(double value) {
  constexpr int kDigits = 3;
  constexpr double kSmallestFixed = 1e-5;
  if (value == 0.0) return QLocale().toString(0);
  // The power of ten after rounding: 9.996 is shown as 10.0.
  const double rounded = QString::number(value, 'e', kDigits - 1).toDouble();
  const int power = static_cast<int>(std::floor(std::log10(std::abs(rounded)) + 1e-9));
  if (std::abs(value) < kSmallestFixed) return QLocale().toString(value, 'e', kDigits - 1);
  return QLocale().toString(value, 'f', std::max(0, kDigits - 1 - power));
}

}  // namespace

QString fillMethodName(FillMethod method) {
  switch (method) {
    case FillMethod::Fair:
      return RepairWords::tr("Fair");
    case FillMethod::Refined:
      return RepairWords::tr("Refined");
    case FillMethod::Ear:
      return RepairWords::tr("Ear clipping");
    case FillMethod::Minimal:
      return RepairWords::tr("Area and bending");
    case FillMethod::Area:
      return RepairWords::tr("Minimum area");
    case FillMethod::Dihedral:
      return RepairWords::tr("Minimum bending");
    case FillMethod::Crease:
      return RepairWords::tr("Ridges");
    case FillMethod::Flat:
      return RepairWords::tr("Flat");
    case FillMethod::Cone:
      return RepairWords::tr("Cone");
    case FillMethod::ThickenedSheet:
      return RepairWords::tr("Thickened sheet");
    case FillMethod::Stitched:
      return RepairWords::tr("Stitched");
    case FillMethod::Removed:
      return RepairWords::tr("Removed");
  }
  return {};
}

QString fillMethodHint(FillMethod method) {
  switch (method) {
    case FillMethod::Fair:
      return RepairWords::tr("Triangles as fine as the surroundings, curved to continue them. For scans.");
    case FillMethod::Refined:
      return RepairWords::tr("Triangles as fine as the surroundings, not curved. For flat regions.");
    case FillMethod::Ear:
      return RepairWords::tr(
          "Cuts off one corner after the other, the best first; adds no vertices. For holes with many edges.");
    case FillMethod::Minimal:
      return RepairWords::tr(
          "Small angles between adjacent triangles, then a small area, using edges of the Delaunay tetrahedralisation; "
          "adds no vertices.");
    case FillMethod::Area:
      return RepairWords::tr("Minimises the area; adds no vertices. A hole of more than 300 edges is divided first.");
    case FillMethod::Dihedral:
      return RepairWords::tr(
          "Minimises the angles between adjacent triangles, then the area; adds no vertices. A hole of more than 300 "
          "edges is divided first.");
    case FillMethod::Crease:
      return RepairWords::tr(
          "As fair, with the sharp edges that end at the hole continued across it. For designed parts.");
    case FillMethod::Flat:
      return RepairWords::tr(
          "A planar patch in the best-fitting plane of the boundary; adds no vertices. For openings that were cut.");
    case FillMethod::Cone:
      return RepairWords::tr("Triangles to one apex behind or in front of the hole.");
    case FillMethod::ThickenedSheet:
      return RepairWords::tr("The sheet was thickened to a thin body.");
    case FillMethod::Stitched:
      return RepairWords::tr("The boundaries were joined.");
    case FillMethod::Removed:
      return RepairWords::tr("The triangles around it were removed.");
  }
  return {};
}

QString substituteText(Substitute substitute, FillMethod method) {
  switch (substitute) {
    case Substitute::None:
      return {};
    case Substitute::LessSmooth:
      return RepairWords::tr(
          "The patch spans the hole without continuing the slopes around it; continuing them, it would bulge out or "
          "intersect the part.");
    case Substitute::OtherMethod:
      return RepairWords::tr("The patch is by “%1”; the chosen method finds no valid patch.")
          .arg(fillMethodName(method));
  }
  return {};
}

QString patchWarning(const PatchComparison& shape) {
  const auto degrees = [](double radian) { return QString::number(std::lround(radian / kRadiansPerDegree)); };
  if (shape.bendsMore())
    return RepairWords::tr("the patch bends by %1°, its surroundings by at most %2°")
        .arg(degrees(shape.bend), degrees(shape.bendAround));
  if (shape.risesMore())
    return RepairWords::tr("the patch bulges by %1 % of the size of the hole beyond its surroundings")
        .arg(std::lround(100.0 * shape.rise / shape.size));
  return {};
}

QString removalWarning(const FarthestRemovedVertex& removed, LengthUnit unit) {
  const auto at = [&](int axis) { return lengthText(removed.position[axis], unit); };
  return RepairWords::tr("A part of the surface that stood out by %1 was removed, at X %2, Y %3, Z %4.")
      .arg(lengthText(removed.distance, unit), at(0), at(1), at(2));
}

QString fillFailureReason(FillFailure failure) {
  switch (failure) {
    case FillFailure::None:
      return {};
    case FillFailure::Cancelled:
      return RepairWords::tr("cancelled");
    case FillFailure::SheetBoundary:
      return RepairWords::tr("it is the outer boundary of an open sheet");
    case FillFailure::WasSheetBoundary:
      return RepairWords::tr(
          "it was the outer boundary of an open sheet, which has been changed so that it looks like a hole now");
    case FillFailure::KeptOpen:
      return RepairWords::tr("it is marked to be kept open");
    case FillFailure::TooLong:
      return RepairWords::tr("it has more edges than allowed");
    case FillFailure::NoPatch:
      return RepairWords::tr("no valid patch fits its boundary");
    case FillFailure::SelfIntersecting:
      return RepairWords::tr("every patch would intersect the part");
    case FillFailure::Bulging:
      return RepairWords::tr("every patch would bulge out too far");
    case FillFailure::NarrowTriangles:
      return RepairWords::tr(
          "no patch fits, perhaps due to narrow triangles along its boundary; “Repair all” removes them");
    case FillFailure::SheetIntersecting:
      return RepairWords::tr("however thin, the body of the sheet would intersect the part");
    case FillFailure::SheetTooThin:
      return RepairWords::tr("the numbers of the file cannot show such a thickness");
    case FillFailure::SheetKeptOpen:
      return RepairWords::tr("a boundary of the sheet is marked to stay open, and a thin body has none");
    case FillFailure::TooMuchEffort:
      return RepairWords::tr("the effort that a mesh of this size allows was used up");
  }
  return {};
}

QString boundaryLoopName(bool isSheetBoundary, int number) {
  return isSheetBoundary ? RepairWords::tr("Outer boundary %1").arg(number) : RepairWords::tr("Hole %1").arg(number);
}

QStringList outcomeTexts(const LoopCounts& loops) {
  QStringList parts;
  const auto add = [&parts](std::size_t count, const auto& phrase) {
    if (count > 0) parts << phrase(asInt(count));
  };
  const OutcomeCounts &holes = loops.holes, &edges = loops.sheetBoundaries;
  if (holes.closed + holes.removed + holes.kept + holes.joined + holes.failed > 0)
    parts << RepairWords::tr("%1 of %n hole(s) filled", nullptr, asInt(holes.all)).arg(holes.closed);
  add(holes.removed, [](int n) { return RepairWords::tr("%n removed together with other triangles", nullptr, n); });
  add(holes.kept, [](int n) { return RepairWords::tr("%n kept open", nullptr, n); });
  add(holes.joined, [](int n) { return RepairWords::tr("%n now part of the boundary of an open sheet", nullptr, n); });
  add(holes.failed, [](int n) { return RepairWords::tr("%n could not be filled", nullptr, n); });
  if (loops.pieces) parts << RepairWords::tr("split or joined, %n hole(s) are left", nullptr, asInt(*loops.pieces));
  if (edges.closed > 0)
    parts << RepairWords::tr("%1 of %n outer boundary(ies) closed", nullptr, asInt(edges.all)).arg(edges.closed);
  add(edges.removed, [](int n) {
    return RepairWords::tr("%n outer boundary(ies) removed together with other triangles", nullptr, n);
  });
  add(loops.newOpenings, [](int n) { return RepairWords::tr("%n new opening(s)", nullptr, n); });
  return parts;
}

QStringList repairSummary(const RepairReport& report, LengthUnit unit) {
  QStringList parts;
  const auto add = [&parts](std::size_t count, const auto& phrase) {
    if (count > 0) parts << phrase(asInt(count));
  };
  add(report.reversedFaces, [](int n) { return RepairWords::tr("%n triangle(s) reversed", nullptr, n); });
  add(report.reversedBodies, [](int n) { return RepairWords::tr("%n body(ies) inside out reversed", nullptr, n); });
  if (const SheetOutcomes& sheets = report.sheets; sheets.leftCount() > 0) {
    parts << RepairWords::tr("sheets: %1").arg(sheetsText(sheets, unit));
  } else if (sheets.thickened > 0) {
    parts << RepairWords::tr("sheets thickened by %1").arg(thicknessText(sheets.thickness, unit));
  }
  add(report.removedDegenerate, [](int n) { return RepairWords::tr("%n degenerate triangle(s) removed", nullptr, n); });
  add(report.removedDuplicates, [](int n) { return RepairWords::tr("%n duplicate triangle(s) removed", nullptr, n); });
  add(report.removedFlaps, [](int n) { return RepairWords::tr("%n dangling triangle(s) removed", nullptr, n); });
  add(report.removedDebris, [](int n) { return RepairWords::tr("%n triangle(s) of debris removed", nullptr, n); });
  add(report.removedLayers,
      [](int n) { return RepairWords::tr("%n triangle(s) of second layers removed", nullptr, n); });
  add(report.stitchedCracks,
      [](int n) { return RepairWords::tr("cracks stitched by moving %n vertex(ices)", nullptr, n); });
  add(report.smoothedVertices,
      [](int n) { return RepairWords::tr("noise smoothed at %n folded vertex(ices)", nullptr, n); });
  add(report.mergedVertices, [](int n) { return RepairWords::tr("%n near vertex(ices) merged", nullptr, n); });
  const auto patches = [&report](Substitute substitute) {
    return static_cast<std::size_t>(
        std::count_if(report.loops.begin(), report.loops.end(), [substitute](const LoopResult& loop) {
          return loop.outcome == LoopOutcome::Filled && loop.newFaces > 0 && loop.substitute == substitute;
        }));
  };
  add(patches(Substitute::LessSmooth),
      [](int n) { return RepairWords::tr("%n patch(es) not continuing the slopes around", nullptr, n); });
  add(patches(Substitute::OtherMethod),
      [](int n) { return RepairWords::tr("%n patch(es) by another method than the chosen one", nullptr, n); });
  add(report.cutFaces, [](int n) { return RepairWords::tr("%n triangle(s) cut where patches intersect", nullptr, n); });
  add(report.cutClusters,
      [](int n) { return RepairWords::tr("self-intersections resolved at %n place(s)", nullptr, n); });
  if (report.innerFaces > 0) parts << RepairWords::tr("bodies that intersect united");
  add(report.lostLoops.size(),
      [](int n) { return RepairWords::tr("%n hole(s) to be kept open lost with removed triangles", nullptr, n); });
  add(report.replacedFaces,
      [](int n) { return RepairWords::tr("%n folded triangle(s) replaced around holes", nullptr, n); });
  add(report.nonOrientableCuts,
      [](int n) { return RepairWords::tr("%n cut(s) where the surface was one-sided", nullptr, n); });
  add(report.separatedVertices,
      [](int n) { return RepairWords::tr("%n touching vertex(ices) separated", nullptr, n); });
  return parts;
}

QString thicknessText(const SheetThickness& thickness, LengthUnit unit) {
  const QString least = significantText(thickness.least / millimetresPer(unit));
  const QString largest = lengthText(thickness.largest, unit);
  const QString text =
      lengthText(thickness.least, unit) == largest ? largest : RepairWords::tr("%1 to %2").arg(least, largest);
  if (thickness.thinVertices == 0) return text;
  return RepairWords::tr("%1, thinner than requested at %2 of %n vertex(ices)", nullptr, asInt(thickness.vertices))
      .arg(text, QLocale().toString(asInt(thickness.thinVertices)));
}

QString sheetsText(const SheetOutcomes& sheets, LengthUnit unit) {
  const std::size_t all = sheets.thickened + sheets.leftCount();
  QStringList parts{sheets.thickened == 0
                        ? RepairWords::tr("none of %1 thickened").arg(QLocale().toString(asInt(all)))
                        : RepairWords::tr("%1 of %2 thickened by %3")
                              .arg(QLocale().toString(asInt(sheets.thickened)), QLocale().toString(asInt(all)),
                                   thicknessText(sheets.thickness, unit))};
  for (const auto& [reason, count] : sheets.left)
    parts << RepairWords::tr("%n sheet(s) left open: %1", nullptr, asInt(count)).arg(fillFailureReason(reason));
  return parts.join(QStringLiteral("; "));
}

QString stateText(const MeshState& state) {
  QStringList parts{state.closed ? RepairWords::tr("closed") : RepairWords::tr("not closed"),
                    state.manifold ? RepairWords::tr("manifold") : RepairWords::tr("not manifold"),
                    state.oriented ? RepairWords::tr("oriented") : RepairWords::tr("not oriented")};
  if (const auto pairs = state.selfIntersectingPairs) {
    parts << (*pairs == 0 ? RepairWords::tr("free of self-intersections")
                          : RepairWords::tr("%n self-intersection(s)", nullptr, asInt(*pairs)));
  }
  parts << (state.components == 1 ? RepairWords::tr("one piece")
                                  : RepairWords::tr("%n piece(s)", nullptr, asInt(state.components)));
  return parts.join(QStringLiteral(", "));
}

QString areaText(double squareMillimetres, LengthUnit unit) {
  return significantText(squareMillimetres / (millimetresPer(unit) * millimetresPer(unit))) + QLatin1Char(' ') +
         QString::fromLatin1(symbolOf(unit)) + QChar(0xb2);
}

QString lengthText(double millimetres, LengthUnit unit) {
  return significantText(millimetres / millimetresPer(unit)) + QLatin1Char(' ') + QString::fromLatin1(symbolOf(unit));
}

}  // namespace handwheel
