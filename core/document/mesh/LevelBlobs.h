// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "mesh/sculpt/PatchLevels.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Writes the coarser subdivision levels of a patch to a container. They are what each level has instead of the mesh:
// blobs "mesh/levels/NNNN/faces" (number, three corners, three opposites of each face of the patch) and
// "mesh/levels/NNNN/points" (three doubles for each vertex of those, by rising number). Their number is in the array
// "levels" of the object "document" of the manifest, the coarsest level first, with the slots from which on the next
// level adds vertices and faces. levels: null for none; its finest mesh is the one that is saved.
void writeLevelBlobs(const PatchLevels* levels, Container& container);

// Reads the subdivision levels of a patch from a container. Their finest mesh is `mesh`; null if it is no longer what
// was saved. Returns null if there are none, or if they do not fit the mesh, for whatever reason: then this is added to
// damage, unless nothing of them is left. O(mesh) for each level, of which there are at most log2(faces). The result is
// invalid if cancelled.
std::shared_ptr<const PatchLevels> readLevelBlobs(const nlohmann::json& document, const Container& container,
                                                  const HalfEdgeMesh* mesh, std::vector<Error>& damage,
                                                  Progress progress);

}  // namespace handwheel
