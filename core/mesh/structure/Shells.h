// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <span>
#include <vector>

namespace handwheel {

// Finds the shells of a mesh: live faces that are connected across edges. Shells are in order of their first face, and
// the faces of a shell are in ascending order. Two bodies that touch in a vertex, or along an edge with four faces, are
// two shells. The result is invalid if cancelled. O(n).
std::vector<std::vector<Face>> findShells(const HalfEdgeMesh& mesh, Progress progress = {});

// Returns the area of the faces of a shell, mm².
double areaOfShell(const HalfEdgeMesh& mesh, std::span<const Face> shell);

// Reverses whole shells: all their faces get the opposite orientation, and neighbours stay neighbours.
void reverseShells(HalfEdgeMesh& mesh, std::span<const Face> faces);

// Extracts faces as a separate mesh. Face i is faces[i], vertices are in order of their first use. Edges to omitted
// faces become border; other edges stay as they were. Each face must be live and occur once.
HalfEdgeMesh extracted(const HalfEdgeMesh& mesh, std::span<const Face> faces);

// Splits a mesh into its shells, in the order of findShells(). Returns an empty list if cancelled. O(n).
std::vector<HalfEdgeMesh> splitIntoShells(const HalfEdgeMesh& mesh, Progress progress = {});

// Appends the live faces of another mesh. They get vertices of their own: nothing is joined, even if borders coincide
// (relink() does that). Returns the number of the first appended face.
Face append(HalfEdgeMesh& mesh, const HalfEdgeMesh& other);

}  // namespace handwheel
