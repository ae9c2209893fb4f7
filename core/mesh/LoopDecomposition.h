// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/HoleContext.h"
#include "mesh/Obstacles.h"
#include "mesh/Patch.h"

#include <optional>
#include <vector>

namespace handwheel {

// Bridges that cut a loop into pieces of at most pieceEdges edges where there are such: short for the border that they
// part (He 2008, section 4.2), never leaving fewer than a quarter of the edges on one side, not along an edge of the
// surface and not through it. Across a slot they zip its two sides. A piece that no bridge can cut stays long. At
// least 4 edges a piece. O(n) memory; time about n per bridge beside the obstacle queries. Once cancelled, those found
// so far.
std::vector<Stitch> proposeStitches(const HoleContext& hole, const Obstacles& obstacles, std::size_t pieceEdges,
                                    Progress progress = {});

// The numbers of a piece's points, in the loop's order: a step to the next number follows the loop, any other a bridge.
using LoopPiece = std::vector<std::uint32_t>;

// None when a bridge is not between two different points that are no neighbours, is there twice, or crosses another.
// O(n + s²) for s stitches.
std::optional<std::vector<LoopPiece>> cutLoop(std::size_t loopSize, const std::vector<Stitch>& stitches);

// A piece as a hole by itself. Behind a bridge it sees the middle of what is on the other side.
HoleContext contextOf(const HoleContext& hole, const LoopPiece& piece);

// The patch of the whole loop, from triangulations of the pieces without new points.
Patch joined(const HoleContext& hole, const std::vector<LoopPiece>& pieces, const std::vector<Patch>& patches);

}  // namespace handwheel
