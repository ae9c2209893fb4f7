// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshChecks.h"
#include "mesh/defects/Defects.h"
#include "mesh/repair/Repair.h"

#include <algorithm>

namespace handwheel::test {

inline std::size_t intersections(const HalfEdgeMesh& mesh) {
  return findSelfIntersections(mesh).value().size();
}

// Returns the input vertices whose position changed or is no longer used by faces.
inline std::set<Vertex> reallyTouched(const HalfEdgeMesh& before, const HalfEdgeMesh& after) {
  const std::set<Coordinates> left = allCoordinates(after.compact().soup);
  std::set<Vertex> touched;
  for (Face f = 0; f < before.faceSlots(); ++f)
    for (Vertex v : before.triangle(f))
      if (!sameBits(before.position(v), after.position(v)) || !left.contains(coordinates(before.position(v))))
        touched.insert(v);
  return touched;
}

inline std::size_t count(const RepairReport& report, LoopOutcome outcome) {
  return std::count_if(report.loops.begin(), report.loops.end(),
                       [&](const LoopResult& loop) { return loop.outcome == outcome; });
}

// Returns the first inconsistency of a report, or an empty string if there is none. The checks apply to every mesh.
inline std::string inconsistent(const HalfEdgeMesh& before, const HalfEdgeMesh& after, const RepairReport& report) {
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(before);
  std::vector<int> seen(loops.size(), 0);
  bool allFilled = true;
  for (const LoopResult& loop : report.loops) {
    if (loop.id >= int(loops.size())) return "an id that the input does not have";
    if (loop.id >= 0) ++seen[loop.id];
    if (loop.id >= 0 && loop.edges != loops[loop.id].borderEdges) return "a loop with the wrong number of edges";
    if ((loop.outcome == LoopOutcome::Filled) != (loop.reason == FillFailure::None))
      return "an outcome without a reason";
    allFilled = allFilled && loop.outcome == LoopOutcome::Filled;
  }
  if (std::any_of(seen.begin(), seen.end(), [](int n) { return n != 1; })) return "a loop is not reported exactly once";
  if (allFilled != (countBorder(after) == 0)) return "all loops are filled if and only if no border is left";
  return {};
}

}  // namespace handwheel::test
