// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "cli/Arguments.h"
#include "haptics/scene/SnapForce.h"
#include "mesh/boundary/BoundaryLoops.h"

namespace handwheel {

// The parameters of snapping to the boundary edges of a mesh.
struct SnapRequest {
  bool isOn = false;
  SnapShape shape = SnapShape::Quadratic;
  SnapMethod method = SnapMethod::Proxy;
  double stiffness = 0.3;  // N/mm
};

// Parses --snap and --snap-method. Returns an error as a sentence, or an empty string.
std::string readSnap(const Arguments& arguments, SnapRequest& request);

// Builds the snap forces for all boundary edges of a mesh. The forces reach as far as the snap distance, which is
// snap.radius times the mean length of the edges. Returns nothing if there are no boundary edges.
std::optional<SnapAttraction> snapAttraction(const SnapRequest& request, const HalfEdgeMesh& mesh,
                                             std::span<const BoundaryLoop> loops, const FidelityValues& values,
                                             Progress progress);

}  // namespace handwheel
