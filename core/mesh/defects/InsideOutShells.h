// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Limits of findInsideOutShells() on pairs of shells and visits of faces. A body full of bubbles reaches them in about
// a second.
inline constexpr std::size_t kMostShellPairs = 10'000'000;
inline constexpr std::size_t kMostShellVisits = 30'000'000;

// Finds the bodies that are inside out. Each is a shell of negative volume that lies in no other shell, together with
// all shells inside it, which must be reversed with it so that a cavity stays a cavity. An open shell has a volume only
// if that is certain: if it exceeds the volume of its openings, each closed by a fan from its centre and a bulge as
// high as it is wide. The result has one list of faces per body. O(n), plus O(faces) of each inside-out shell for each
// shell whose box contains it. Returns an empty list if cancelled or if a limit above is exceeded.
std::vector<std::vector<Face>> findInsideOutShells(const HalfEdgeMesh& mesh, Progress progress = {});

// Finds closed shells with material on both sides, such as a body inside another. They bound no part of the union. A
// cavity, whose shell faces inward, is not one; for intersecting shells a single point decides. The result has one list
// of faces per shell. Limits and cost as above.
std::vector<std::vector<Face>> findNestedBodies(const HalfEdgeMesh& mesh, Progress progress = {});

// The results of both functions above, with a time limit for use on every mesh. The search for nested bodies takes at
// most a tenth of a second; if that does not suffice, none are reported.
struct ShellFaults {
  std::vector<std::vector<Face>> insideOut;
  std::size_t nestedBodies = 0;
};
ShellFaults findShellFaults(const HalfEdgeMesh& mesh, Progress progress = {});

// Reverses the bodies that are inside out. Returns the number of reversed faces.
std::size_t orientOutward(HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
