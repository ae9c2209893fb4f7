// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/simplify/Decimation.h"

namespace handwheel {

// Simplifies a mesh by OpenMesh's decimater and quadrics (Garland and Heckbert, 1997). decimate() calls it for
// DecimationMethod::Quadric. The mesh must have no degenerate faces; if cancelled or refused, it is unchanged. Vertices
// with more than kMostFacesOfCollapse faces stay, because the time for a vertex is quadratic in its faces.
OpenMeshRefusal decimateByQuadrics(HalfEdgeMesh& mesh, const DecimationOptions& options, Progress progress = {});
inline constexpr unsigned kMostFacesOfCollapse = 256;

}  // namespace handwheel
