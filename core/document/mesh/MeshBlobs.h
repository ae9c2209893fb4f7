// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "mesh/MeshBuilder.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Blobs "mesh/positions/NNNN" (three doubles a vertex) and "mesh/faces/NNNN" (three corners and three opposites a
// face), 65,536 slots to a blob, dead slots included, so that every number keeps its meaning. How many there are stands
// in the object "document" of the manifest.
void writeMeshBlobs(const HalfEdgeMesh& mesh, Container& container);

struct LoadedMesh {
  HalfEdgeMesh mesh;
  BuildReport report;    // when it had to be built anew
  bool isWhole = false;  // slot for slot what was written; else built from the triangles that are left, renumbered
};

// A mesh that breaks an invariant, or has lost blobs, is built anew from the triangles that can still be read; damage
// says so. Errors: NoTriangles, Cancelled.
Result<LoadedMesh> readMeshBlobs(const nlohmann::json& document, const Container& container, std::vector<Error>& damage,
                                 Progress progress);

}  // namespace handwheel
