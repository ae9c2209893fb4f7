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
  bool isCutShort = false;         // a trial took too much effort, or there was none left for one
};

// Closes loops of the mesh by patches that may cross the part, which is then cut and uncrossed there (uncross()), or
// by giving their sheet a back (backSheet()), which closes every loop of the sheet, so not where one has
// FillOptions::keptCorners. Takes only what leaves no more crossings than there were, and fewer edges
// without two faces. All are tried together, then by halves, so that a bad one costs its own closing only.
// thickness: of backs, mm. Takes no more than tolerance::kHardHoleEffort, nor than the effort of the progress: what is
// still open then stays so, and the mesh is as the last closing left it. A trial takes the faces near its holes
// (MeshPart), and O(n) to find them; all of the mesh where these are half of it, or with backs. O(n) for each that is
// kept.
HardClosings closeHardHoles(HalfEdgeMesh& mesh, std::span<const HardHole> holes, const FillOptions& options,
                            double thickness, Progress progress = {});

}  // namespace handwheel
