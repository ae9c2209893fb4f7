// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Operation.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "volume/SparseVolume.h"
#include "volume/surface/VolumeSurface.h"

#include <optional>
#include <string>

namespace handwheel {

// Returns a parameter for a length in mm, without a default.
Parameter lengthParameter(const char* id, const char* label, std::string meaning, double least = 1e-9,
                          double largest = 1e9);

// Makes a volume of a surface: its parameters are the voxel, the method and the thickness of walls.
const Operation& voxelizeOperation();

// Makes a mesh of a volume's surface, with fewer triangles if the parameters require it.
const Operation& remeshOperation();

struct Remeshed {
  HalfEdgeMesh mesh;
  std::size_t before = 0;                 // triangles of the surface
  std::optional<double> largestDistance;  // largest distance from it, mm; none: not reduced
};

// Returns the approximate number of triangles of remesh(): that of the surface, or the requested one; for a distance it
// is estimated on sample pieces of the surface. 0 if cancelled.
double predictedTriangles(const VolumeSurface& surface, const OperationValues& values, Progress progress = {});

// Errors: Cancelled.
Result<Remeshed> remesh(const SparseVolume& volume, const OperationValues& values, Progress progress);

}  // namespace handwheel
