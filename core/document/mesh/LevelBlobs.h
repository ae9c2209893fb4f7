// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "mesh/PatchLevels.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// What the coarser levels of a patch have instead of the mesh, level by level: blobs "mesh/levels/NNNN/faces" (number,
// three corners, three opposites of each face of the patch) and "mesh/levels/NNNN/points" (three doubles for each
// vertex of those, by rising number). How many there are stands in the array "levels" of the object "document" of the
// manifest, the coarsest level first. levels: null for none; its finest mesh is the one that is saved.
void writeLevelBlobs(const PatchLevels* levels, Container& container);

// The levels whose finest mesh this is; mesh: null where it is no longer what was saved. Null where there are none, or
// where what is there does not fit the mesh, by whichever hand: then damage says so, unless none of it is left. O(mesh)
// for each level, of which there are at most log2(faces). Of no use once cancelled.
std::shared_ptr<const PatchLevels> readLevelBlobs(const nlohmann::json& document, const Container& container,
                                                  const HalfEdgeMesh* mesh, std::vector<Error>& damage,
                                                  Progress progress);

}  // namespace handwheel
