// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/HalfEdgeMesh.h"

#include <map>
#include <vector>

namespace handwheel {

// A file holds positions, not vertices: an edge is crowded when more than two faces have its two ends by position.

// The fans at each position at the end of a crowded edge, by class of position. What there is so far once cancelled.
using Fans = std::map<Vertex, std::vector<HalfEdge>>;
std::map<std::uint32_t, Fans> crowdedFans(const HalfEdgeMesh& mesh, Progress progress = {});

// One half-edge of each pair of faces beyond the first at every crowded edge.
std::vector<HalfEdge> surplusEdges(const HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
