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

// Returns the operation that makes a volume from a surface. Its parameters are the voxel, the method and the thickness
// of walls.
const Operation& voxelizeOperation();

// Returns the operation that makes a mesh from a volume's surface, with fewer triangles if the parameters require it.
const Operation& remeshOperation();

struct Remeshed {
  HalfEdgeMesh mesh;
  std::size_t before = 0;                 // number of triangles of the surface
  std::optional<double> largestDistance;  // largest distance from the surface, mm; none: not reduced
};

// The approximate result of remesh().
struct RemeshPrediction {
  double triangles = 0.0;
  double seconds = 0.0;  // time on this machine, s
};
// Returns the prediction. The triangles are those of the surface, or the requested number. For a largest distance, they
// are estimated from sample pieces of the surface, apart from what is near their borders; so is the time. The result is
// invalid if cancelled.
RemeshPrediction predictRemesh(const VolumeSurface& surface, const OperationValues& values, Progress progress = {});

// Makes the mesh of remeshOperation(). Error: Cancelled.
Result<Remeshed> remesh(const SparseVolume& volume, const OperationValues& values, Progress progress);

}  // namespace handwheel
