// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/HalfEdgeMesh.h"

#include <span>
#include <vector>

namespace handwheel {

// The live faces by shell, what hangs together across edges: shells in order of their first face, faces in order. Two
// bodies that touch in a vertex, or along an edge with four faces, are two shells. Of no use once cancelled. O(n).
std::vector<std::vector<Face>> findShells(const HalfEdgeMesh& mesh, Progress progress = {});

// These faces alone, as a mesh of their own: face i is faces[i], vertices stand in order of their first use. Edges to
// faces left out are border; those to others stay as they were. Each face is live and named once.
HalfEdgeMesh extracted(const HalfEdgeMesh& mesh, std::span<const Face> faces);

// Every shell as a mesh of its own, in the order of findShells(). Empty once cancelled. O(n).
std::vector<HalfEdgeMesh> splitIntoShells(const HalfEdgeMesh& mesh, Progress progress = {});

// Adds the live faces of another mesh behind those that are there, with vertices of their own: nothing is joined, even
// where borders coincide (relink() does that). Returns the number of the first.
Face append(HalfEdgeMesh& mesh, const HalfEdgeMesh& other);

}  // namespace handwheel
