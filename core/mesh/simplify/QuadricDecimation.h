// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/simplify/Decimation.h"

namespace handwheel {

// Simplifies a mesh by OpenMesh's decimater and quadrics (Garland and Heckbert, 1997). What decimate() does by
// DecimationMethod::Quadric. The mesh must have no degenerate faces; if cancelled or refused, it is unchanged. Vertices
// with more faces than kMostFacesOfCollapse stay, as its time for one goes with the square of them.
OpenMeshRefusal decimateByQuadrics(HalfEdgeMesh& mesh, const DecimationOptions& options, Progress progress = {});
inline constexpr unsigned kMostFacesOfCollapse = 256;

}  // namespace handwheel
