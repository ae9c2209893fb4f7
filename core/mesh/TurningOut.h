// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/HalfEdgeMesh.h"

namespace handwheel {

// Turns closed shells that are inside out: each shell with a negative volume that lies in no other closed one, and with
// it all that lies in it, so that a cavity stays one. Open shells stay as they are. Returns how many faces were turned.
// O(n), and for each shell in whose box a shell that is inside out lies, O(faces of that). Nothing is turned once
// cancelled, or where that would be more pairs of shells or visits of faces than these: a second, where a body is full
// of bubbles.
inline constexpr std::size_t kMostShellPairs = 10'000'000;
inline constexpr std::size_t kMostShellVisits = 30'000'000;
std::size_t turnOut(HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
