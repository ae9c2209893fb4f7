// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Limits of orientOutward() on pairs of shells and visits of faces: a second, where a body is full of bubbles.
inline constexpr std::size_t kMostShellPairs = 10'000'000;
inline constexpr std::size_t kMostShellVisits = 30'000'000;
// Reverses closed shells that are inside out. That is each shell with a negative volume that lies in no other closed
// one, and with it all that lies in it, so that a cavity stays one. Open shells stay as they are. Returns the number of
// reversed faces. O(n), and for each shell in whose box a shell that is inside out lies, O(faces of that). Nothing is
// reversed if cancelled, or where that would exceed the limits above.
std::size_t orientOutward(HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
