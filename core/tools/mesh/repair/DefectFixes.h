// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "mesh/selection/FaceSelection.h"
#include "tools/mesh/MeshServices.h"

#include <QtGlobal>
#include <utility>
#include <vector>

namespace handwheel {

// Reasons why defects may remain, as in MeshChange::reason.
inline constexpr const char* kPlateSides =
    QT_TRANSLATE_NOOP("Tool", "they are the two sides of a plate of zero thickness, which is closed");
inline constexpr const char* kCrowdsEdges =
    QT_TRANSLATE_NOOP("Tool", "merging them would make edges with more than two triangles");
inline constexpr const char* kMergesNothing = QT_TRANSLATE_NOOP(
    "Tool", "no two vertices can be merged so that an open edge closes and none gets a third triangle");
inline constexpr const char* kNotSeparable =
    QT_TRANSLATE_NOOP("Tool", "every separation would make the surface intersect itself");
inline constexpr const char* kNoCleanSeparation =
    QT_TRANSLATE_NOOP("Tool", "no cut would separate the triangles cleanly");
inline constexpr const char* kNoCleanCut =
    QT_TRANSLATE_NOOP("Tool", "the cut could not be closed without intersecting the part");
inline constexpr const char* kNoUnion =
    QT_TRANSLATE_NOOP("Tool",
                      "only closed bodies can be united: close holes and open sheets, and reverse bodies that are "
                      "inside out before");

// Each of these functions creates the change that repairs one kind of defect, with its script step. The change affects
// only the defects and their surroundings. If faces, vertices or pairs are given, only defects at these are repaired;
// otherwise all.

// Removes degenerate faces. If faces are given, only these and the degenerate faces connected with them are removed.
MeshChange degenerateFix(const FaceSelection& faces = {});
// Removes duplicate faces.
MeshChange duplicateFix(const FaceSelection& faces = {});
// Merges pairs of vertices that lie near each other. nearWeld: the largest distance, as a fraction of the diagonal.
MeshChange nearVertexFix(double nearWeld, std::vector<std::pair<Vertex, Vertex>> pairs = {});
// Separates edges with more than two faces, and parts connected at a vertex only. They are moved apart in the last
// digits of the coordinates. vertices: only defects at the positions of these vertices are repaired, and only edges
// between two of them.
MeshChange nonManifoldFix(NumberType numbers, std::vector<Vertex> vertices = {});
// Makes non-orientable (one-sided) parts orientable. Cuts them along short paths until they have two sides, and closes
// the cuts. vertices: only the components at the positions of these vertices are repaired.
MeshChange nonOrientableFix(const FillOptions& options, std::vector<Vertex> vertices = {});
// Resolves self-intersections by cutting and rejoining the faces. pairs: the intersecting faces as returned by
// findSelfIntersections().
MeshChange intersectionFix(NumberType numbers, std::vector<std::pair<Face, Face>> pairs);
// Unites the solids that intersect: the walls inside the union are removed.
MeshChange unionFix(NumberType numbers);
// Removes the loose pieces that contain one of these faces.
MeshChange debrisFix(std::vector<Face> faces);
// Removes all faces that findDefects() reports as debris.
MeshChange allDebrisFix();
// Reverses the bodies that are inside out.
MeshChange insideOutFix();
// Reverses single faces: the fewest in each part so that neighbours agree, or the given ones.
MeshChange orientFix(const FaceSelection& faces = {});
// Reverses the shells that contain one of these faces. The faces of a shell always agree, so it is reversed as a whole.
MeshChange reverseChange(const FaceSelection& faces);

}  // namespace handwheel
