// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Snapshot.h"
#include "mesh/defects/Defects.h"
#include "mesh/sculpt/PatchLevels.h"
#include "mesh/structure/MeshBuilder.h"

#include <set>

namespace handwheel {

// The value of a mesh document.
struct MeshSnapshot : Snapshot {
  InspectedMesh mesh;
  std::shared_ptr<const BuildReport> build;  // what building the mesh from its file reported; never null
  std::set<Vertex> keptOpen;                 // keyOf() the loops that the user wants open
  NumberType numbers = NumberType::Float64;  // of the coordinates in the file that it came from
  // The same with the directions of the file, where opening has reversed faces; null elsewhere, and once opened.
  std::shared_ptr<const InspectedMesh> asInFile;
  std::shared_ptr<const PatchLevels> levels;  // whose finest mesh this is; null for none
};

}  // namespace handwheel
