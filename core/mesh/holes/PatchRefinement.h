// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/holes/Fairing.h"
#include "mesh/holes/HoleContext.h"
#include "mesh/holes/Patch.h"

#include <optional>
#include <utility>

namespace handwheel {

// Pairs of loop points that an edge of the surface joins. Each has the smaller index first; the pairs are sorted.
using JoinedPoints = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Refines a patch to even triangles. These are as long as the edges of the loop, divided by density /
// tolerance::kPatchDensity; if that needs more than tolerance::kPatchVertices vertices, or
// tolerance::kPatchVerticesPerEdge for each edge of the loop, they grow with the distance from the loop. No edge of the
// result joins two points that an edge of the surface joins already. Returns nothing if a vertex of patch or
// surroundings has more than tolerance::kLibraryFanFaces faces, if the patch is not manifold, or if cancelled.
std::optional<Patch> refinePatch(const HoleContext& hole, const Patch& start, double density = tolerance::kPatchDensity,
                                 const JoinedPoints& joined = {}, Progress progress = {});

// Bends a refined patch by fair(), so that it continues the faces around the hole with this continuity. held: points
// inside the patch with the positions that they get. Returns nothing if there is no such surface, or if cancelled.
std::optional<Patch> fairPatch(const HoleContext& hole, Patch patch, Continuity continuity,
                               const std::vector<std::pair<std::uint32_t, Vec3>>& held = {}, Progress progress = {});

}  // namespace handwheel
