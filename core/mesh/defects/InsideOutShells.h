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
// all shells inside it, which must be reversed with it so that a cavity stays a cavity. The volume of an open shell,
// whose openings are closed by fans from their centres, counts only if its sign is certain: if it exceeds the volume of
// possible bulges over the openings, each as high as the opening is wide. The result has one list of faces per body.
// O(n) plus O(f) for each pair of an inside-out shell with f faces and a shell whose box contains it. Returns an empty
// list if cancelled or if kMostShellPairs or kMostShellVisits is exceeded.
std::vector<std::vector<Face>> findInsideOutShells(const HalfEdgeMesh& mesh, Progress progress = {});

// Finds closed shells with material on both sides, such as a body inside another. Such shells bound no part of the
// union of the solids. The shell of a cavity faces inward and does not count. For intersecting shells, the sides are
// tested at a single point. The result has one list of faces per shell. The limits and the cost are those of
// findInsideOutShells().
std::vector<std::vector<Face>> findNestedBodies(const HalfEdgeMesh& mesh, Progress progress = {});

// The results of findInsideOutShells() and findNestedBodies(). The search for nested bodies takes at most a tenth of a
// second, so that it can be used on every mesh; if that does not suffice, no nested bodies are reported.
struct ShellFaults {
  std::vector<std::vector<Face>> insideOut;
  std::size_t nestedBodies = 0;
};
ShellFaults findShellFaults(const HalfEdgeMesh& mesh, Progress progress = {});

// Reverses the bodies that are inside out. Returns the number of reversed faces.
std::size_t orientOutward(HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
