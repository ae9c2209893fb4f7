// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HoleFilling.h"

#include <span>

namespace handwheel {

// A loop that no patch closes without crossing or touching the part.
struct HardHole {
  BoundaryLoop loop;
  bool back = false;  // by a back to its sheet rather than by a patch
};

struct HardClosing {
  bool closed = false;
  FillMethod method = FillMethod::Fair;
  std::size_t newFaces = 0;  // before anything was cut
};

struct HardClosings {
  std::vector<HardClosing> holes;  // one for each
  std::size_t cutFaces = 0;        // of the part, where patches cross it
  std::size_t work = 0;            // faces gone through in trials; a face to cut counts for many
};

// Closes loops of the mesh by patches that may cross the part, which is then cut and uncrossed there (uncross()), or
// by giving their sheet a back (backSheet()), which closes every loop of the sheet, so not where one has
// FillOptions::keptCorners. Takes only what leaves no more crossings than there were, and fewer edges
// without two faces. All are tried together, then by halves, so that a bad one costs its own closing only.
// thickness: of backs, mm. No trial begins once the work is over mostWork. A trial takes the faces near its holes
// (MeshPart), and O(n) to find them; all of the mesh where these are half of it, or with backs. O(n) for each that is
// kept.
HardClosings closeHardHoles(HalfEdgeMesh& mesh, std::span<const HardHole> holes, const FillOptions& options,
                            double thickness, std::size_t mostWork, Progress progress = {});

}  // namespace handwheel
