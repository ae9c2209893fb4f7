// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "mesh/structure/MeshBuilder.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Writes a mesh to the blobs of a container. Blobs "mesh/positions/NNNN" (three doubles per vertex) and
// "mesh/faces/NNNN" (three corners and three opposites per face), 65,536 slots per blob, dead slots included, so that
// every index stays valid. Their number is in the object "document" of the manifest.
void writeMeshBlobs(const HalfEdgeMesh& mesh, Container& container);

// Result of reading a mesh from a container.
struct LoadedMesh {
  HalfEdgeMesh mesh;
  BuildReport report;    // when it had to be rebuilt
  bool isWhole = false;  // slot for slot what was written; else built from the triangles that are left, renumbered
};

// Reads a mesh from the blobs of a container. A mesh that violates an invariant, or has lost blobs, is rebuilt from the
// triangles that can still be read; this is added to damage. damage: what is known of the container. Errors: if no
// triangle is left of some, the damage that explains it; NoTriangles, Cancelled.
Result<LoadedMesh> readMeshBlobs(const nlohmann::json& document, const Container& container, std::vector<Error>& damage,
                                 Progress progress);

}  // namespace handwheel
