// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "document/Snapshot.h"
#include "mesh/defects/Defects.h"
#include "mesh/sculpt/PatchLevels.h"
#include "mesh/structure/MeshBuilder.h"

#include <set>

namespace handwheel {

// The value of a mesh document.
struct MeshSnapshot : Snapshot {
  InspectedMesh mesh;
  std::shared_ptr<const BuildReport> build;  // report of building the mesh from its file; never null
  std::set<Vertex> keptOpen;                 // keys (keyOf()) of the loops that the user wants open
  NumberType numbers = NumberType::Float64;  // number type of the coordinates in the original file
  // The mesh with the face directions of the file, if faces were reversed when it was read; otherwise, and in snapshots
  // of an open document, null.
  std::shared_ptr<const InspectedMesh> asInFile;
  FidelityValues fillChoice;                  // the value of MeshDocument::fillChoice()
  std::shared_ptr<const PatchLevels> levels;  // subdivision levels whose finest mesh is this one; null: none
};

}  // namespace handwheel
