// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/holes/HoleContext.h"
#include "mesh/holes/Obstacles.h"
#include "mesh/holes/Patch.h"

#include <optional>
#include <vector>

namespace handwheel {

// Finds bridges that divide a boundary loop into pieces of at most pieceEdges edges. They are short relative to the
// border that they separate (He 2008, section 4.1.4), leave at least a quarter of the edges on each side, and run
// neither along an edge of the surface nor through the surface. Bridges across a slot connect its two sides. A piece
// that no bridge can divide stays long. Each piece has at least 4 edges. O(n) memory; the time is about O(n) per bridge
// plus the obstacle queries. If cancelled, the function returns the bridges found so far.
std::vector<HoleBridge> proposeHoleBridges(const HoleContext& hole, const Obstacles& obstacles, std::size_t pieceEdges,
                                           Progress progress = {});

// The indices of a piece's points, in the loop's order. An edge of the piece between consecutive loop points is an edge
// of the loop; any other edge is a bridge.
using HolePiece = std::vector<std::uint32_t>;

// Splits a loop into pieces along bridges. Returns nothing if a bridge joins equal or neighbouring points, occurs
// twice, or crosses another. O(n + s²) for s bridges.
std::optional<std::vector<HolePiece>> splitHole(std::size_t loopSize, const std::vector<HoleBridge>& bridges);

// Returns the context of a piece as a separate hole. The apex of a bridge (HoleContext::apexes) is the middle point of
// the loop on the other side of the bridge.
HoleContext contextOf(const HoleContext& hole, const HolePiece& piece);

// Joins the patches of the pieces into the patch of the whole loop. The patches must have no added points.
Patch joined(const HoleContext& hole, const std::vector<HolePiece>& pieces, const std::vector<Patch>& patches);

}  // namespace handwheel
