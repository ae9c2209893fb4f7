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

// Parses --snap and --snap-method. Returns the error as a sentence, or nothing.
std::string readSnap(const Arguments& arguments, SnapRequest& request);

// Builds the snap forces for all boundary edges of a mesh. They reach as far as the snap distance, which is snap.radius
// times the mean length of the edges. Nothing if there are no boundary edges.
std::optional<SnapAttraction> snapAttraction(const SnapRequest& request, const HalfEdgeMesh& mesh,
                                             std::span<const BoundaryLoop> loops, const FidelityValues& values,
                                             Progress progress);

}  // namespace handwheel
