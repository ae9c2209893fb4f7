// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Limits of findInsideOutShells() on pairs of shells and visits of faces. They take a second, where a body is full of
// bubbles.
inline constexpr std::size_t kMostShellPairs = 10'000'000;
inline constexpr std::size_t kMostShellVisits = 30'000'000;

// Finds the bodies that are inside out. Each is a shell of negative volume that lies in no other one, and all that lies
// in it, which has to be reversed with it, so that a cavity stays one. An open shell has a volume where that is
// certain: where it is more than its openings could hold, each with a fan from its centre and a bulge as high as it is
// wide. One list of faces a body. O(n), and for each shell in whose box a shell that is inside out lies, O(faces of
// that). None if cancelled, or where that would exceed the limits above.
std::vector<std::vector<Face>> findInsideOutShells(const HalfEdgeMesh& mesh, Progress progress = {});

// Finds the shells that bound nothing of the union: closed ones with material on both sides, as a body inside another.
// Not a cavity, whose shell looks inward; of what intersects the answer is that of one point. One list of faces a
// shell. Limits and cost as above.
std::vector<std::vector<Face>> findNestedBodies(const HalfEdgeMesh& mesh, Progress progress = {});

// What both functions above find, for who looks at every mesh. Nested bodies are searched for a tenth of a second at
// most, and none are found where that is not enough.
struct ShellFaults {
  std::vector<std::vector<Face>> insideOut;
  std::size_t nestedBodies = 0;
};
ShellFaults findShellFaults(const HalfEdgeMesh& mesh, Progress progress = {});

// Reverses the bodies that are inside out. Returns the number of reversed faces.
std::size_t orientOutward(HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
