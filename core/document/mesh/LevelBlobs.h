// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "mesh/sculpt/PatchLevels.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Writes the coarser subdivision levels of a patch to a container. Each level consists of the blobs
// "mesh/levels/NNNN/faces" (number, three corners and three opposites of each face of the patch) and
// "mesh/levels/NNNN/points" (three doubles for each vertex of these faces, in ascending order of vertices). The array
// "levels" of the object "document" of the manifest holds the number of their blobs, the coarsest level first, with the
// slots from which on the next level adds vertices and faces. The finest mesh is not among them: it is the mesh that is
// saved. levels: null for none.
void writeLevelBlobs(const PatchLevels* levels, Container& container);

// Reads the subdivision levels of a patch from a container. mesh: their finest mesh; null if it is no longer the saved
// one. Returns null if there are no levels, or if they do not fit the mesh for any reason; in the latter case an error
// is added to damage, unless no level is left at all. O(mesh) for each level, of which there are at most log2(faces).
// The result is invalid if cancelled.
std::shared_ptr<const PatchLevels> readLevelBlobs(const nlohmann::json& document, const Container& container,
                                                  const HalfEdgeMesh* mesh, std::vector<Error>& damage,
                                                  Progress progress);

}  // namespace handwheel
