// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "mesh/structure/MeshBuilder.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Writes a mesh to the blobs of a container. The blobs are "mesh/positions/NNNN" (three doubles per vertex) and
// "mesh/faces/NNNN" (three corners and three opposite half-edges per face), with 65,536 vertices or faces per blob. The
// slots of deleted vertices and faces are included, so that every index stays valid. The object "document" of the
// manifest contains the number of slots.
void writeMeshBlobs(const HalfEdgeMesh& mesh, Container& container);

// Result of reading a mesh from a container.
struct LoadedMesh {
  HalfEdgeMesh mesh;
  BuildReport report;    // report of the building, if the mesh had to be rebuilt
  bool isWhole = false;  // the mesh has the slots that were written; otherwise it is rebuilt from the remaining
                         // triangles and renumbered
};

// Reads a mesh from the blobs of a container. A mesh that violates an invariant, or has lost blobs, is rebuilt from the
// triangles that can still be read; an error is then added to damage. damage: the known damage of the container on
// input. Errors: the damage that explains why no triangle is left, NoTriangles, Cancelled.
Result<LoadedMesh> readMeshBlobs(const nlohmann::json& document, const Container& container, std::vector<Error>& damage,
                                 Progress progress);

}  // namespace handwheel
