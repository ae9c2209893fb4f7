// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/UnmodifiedVerticesCheck.h"

#include "mesh/structure/Weld.h"

namespace handwheel {

bool unmodifiedAreIdentical(const HalfEdgeMesh& before, const HalfEdgeMesh& after, const std::vector<Vertex>& modified,
                            const TriangleSoup& written) {
  std::vector<bool> mustBeThere(before.vertexSlots(), false);
  for (Face f = 0; f < before.faceSlots(); ++f) {
    if (!before.isLive(f) || !after.isLive(f)) continue;
    for (Vertex v : before.triangle(f)) mustBeThere[v] = true;
  }
  for (Vertex v : modified) {
    if (v < mustBeThere.size()) mustBeThere[v] = false;
  }

  // One class per position: those of the file's triangles first, so a class beyond them is a position it does not have.
  std::vector<Vec3> points;
  for (const Triangle& t : written.triangles) {
    for (std::uint32_t v : t) points.push_back(written.points[v]);
  }
  const std::size_t inFile = points.size();
  for (Vertex v = 0; v < before.vertexSlots(); ++v) {
    if (mustBeThere[v]) points.push_back(before.position(v));
  }
  const PointClasses classes = classifyPoints(points);
  for (std::uint32_t first : classes.representative) {
    if (first >= inFile) return false;
  }
  return true;
}

}  // namespace handwheel
