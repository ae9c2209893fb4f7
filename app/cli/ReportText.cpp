// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ReportText.h"

#include "base/NumberText.h"
#include "mesh/boundary/LoopNumbers.h"
#include "text/RepairText.h"

#include <cmath>
#include <limits>

namespace handwheel {

namespace {

std::string line(std::string_view name, const std::string& value) {
  constexpr std::size_t kColumn = 26;
  return std::string(name) + std::string(kColumn - name.size(), ' ') + value + "\n";
}

std::string point(const Vec3& p) {
  return roundedText(p.x()) + ", " + roundedText(p.y()) + ", " + roundedText(p.z());
}

// Describes the edges at which the triangles of the file, before any are reversed on opening, are not consistently
// oriented.
std::string disagreementText(const MeshReport& report) {
  std::string text = std::to_string(report.inconsistentEdges) + (report.inconsistentEdges == 1 ? " edge" : " edges");
  if (report.reversedFaces > 0)
    text += "; opening reverses " + std::to_string(report.reversedFaces) +
            (report.reversedFaces == 1 ? " triangle" : " triangles");
  return text;
}

// Returns the table of the holes, or of the outer edges of open sheets; empty if there are none. Columns: the name as
// in the window; the id as in options and steps.
std::string loopTable(const std::vector<LoopReport>& loops, bool isOfSheets, const std::string& title) {
  constexpr std::size_t kName = 20;
  std::string table = "\n" + title + "\n" + std::string(kName - 4, ' ') +
                      "name    id   edges     length (mm)      area (mm2)   planarity   islands\n";
  bool isAny = false;
  LoopNumbers numbers;
  for (const LoopReport& loop : loops) {
    if (loop.isSheetBoundary != isOfSheets) continue;
    isAny = true;
    table += rightAligned(boundaryLoopName(isOfSheets, numbers.take(isOfSheets)).toStdString(), kName) +
             rightAligned(std::to_string(loop.id), 6) + rightAligned(std::to_string(loop.edges), 8) +
             rightAligned(roundedText(loop.lengthMm), 16) + rightAligned(roundedText(loop.areaMm2), 16) +
             rightAligned(roundedText(loop.planarity), 12) + rightAligned(std::to_string(loop.islands), 10) + "\n";
  }
  return isAny ? table : std::string();
}

}  // namespace

std::string rightAligned(const std::string& text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 0, ' ') + text;
}

std::string readableText(const MeshReport& report) {
  std::string text;
  text += line("Triangles", std::to_string(report.triangles));
  text += line("Vertices", std::to_string(report.vertices));
  text += line("State", stateText(report).toStdString());
  if (!report.oriented) text += line("Orientation disagrees at", disagreementText(report));
  if (report.oneSidedPieces > 0)
    text +=
        line("One-sided", std::to_string(report.oneSidedPieces) +
                              (report.oneSidedPieces == 1 ? " piece, which cannot be oriented, as a Möbius strip"
                                                          : " pieces, which cannot be oriented, as a Möbius strip"));
  if (report.insideOutBodies > 0)
    text += line("Inside out",
                 std::to_string(report.insideOutBodies) + (report.insideOutBodies == 1 ? " body" : " bodies"));
  if (report.nestedBodies > 0)
    text +=
        line("Inside others", std::to_string(report.nestedBodies) + (report.nestedBodies == 1 ? " body" : " bodies"));
  text += line("Boundary loops", std::to_string(report.loops.size()));
  text += line("Non-manifold edges", std::to_string(report.nonManifoldEdges));
  text += line("Non-manifold vertices", std::to_string(report.nonManifoldVertices));
  text += line("Degenerate triangles", std::to_string(report.degenerateFaces));
  text += line("Duplicate triangles", std::to_string(report.duplicateFaces));
  if (report.nearVertices > 0) text += line("Near vertices (pairs)", std::to_string(report.nearVertices));
  if (report.debris > 0) text += line("Debris (pieces)", std::to_string(report.debris));
  std::string volume = report.volumeMm3
                           ? roundedText(*report.volumeMm3)
                           : std::string("undefined, ") + (report.oneSidedPieces > 0 ? "the surface is one-sided"
                                                           : report.closed ? "neighbours disagree about the inside"
                                                                           : "the surface is open");
  if (report.volumeMm3 && std::isinf(*report.volumeMm3)) volume = "too large for a number";
  if (report.volumeMm3 && *report.volumeMm3 == 0.0 && report.box.sizes().minCoeff() > 0.0 &&
      report.box.sizes().prod() < std::numeric_limits<double>::min())
    volume = "too small for a number";
  if (report.volumeMm3 && report.nestedBodies > 0) volume += ", of all bodies added up";
  text += line("Area (mm2)", roundedText(report.areaMm2));
  text += line("Volume (mm3)", volume);
  text += line("Bounding box (mm)", point(report.box.min()) + " to " + point(report.box.max()));
  text += loopTable(report.loops, false, "Holes");
  text += loopTable(report.loops, true, "Outer boundaries of open sheets");
  return text;
}

}  // namespace handwheel
