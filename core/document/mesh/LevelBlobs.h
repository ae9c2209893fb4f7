// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "mesh/sculpt/PatchLevels.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Writes the coarser subdivision levels of a patch to a container. Each level consists of the blobs
// "mesh/levels/NNNN/faces" (number, three corners and three opposite half-edges of each face of the patch) and
// "mesh/levels/NNNN/points" (three doubles for each vertex of these faces, in ascending order of vertices). The array
// "levels" of the object "document" of the manifest contains an entry for each level, the coarsest first: the numbers
// of its slots, patch faces and points, and the first slots of the vertices and faces that the next level adds. The
// finest level is not written, because it is the saved mesh. levels: null: no levels.
void writeLevelBlobs(const PatchLevels* levels, Container& container);

// Reads the subdivision levels of a patch from a container. mesh: the finest mesh of the levels; null: the saved mesh
// is no longer that mesh. Returns null if there are no levels, their blobs are missing, or they do not fit the mesh; in
// the last case an error is added to damage. O(mesh) for each level, of which there are at most log2(faces). The result
// is invalid if cancelled.
std::shared_ptr<const PatchLevels> readLevelBlobs(const nlohmann::json& document, const Container& container,
                                                  const HalfEdgeMesh* mesh, std::vector<Error>& damage,
                                                  Progress progress);

}  // namespace handwheel
