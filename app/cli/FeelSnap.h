// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "cli/Arguments.h"
#include "haptics/SceneForces.h"
#include "mesh/BoundaryLoops.h"

namespace handwheel {

// How the rims of a mesh draw a tip that is led over it.
struct SnapRequest {
  bool isOn = false;
  SnapShape shape = SnapShape::Quadratic;
  SnapMethod method = SnapMethod::Proxy;
  double stiffness = 0.3;  // N/mm
};

// What --snap and --snap-method say; what is wrong with them, as a sentence, or nothing.
std::string readSnap(const Arguments& arguments, SnapRequest& request);

// Points and edges of all open edges, within the snap distance that snap.radius makes of their mean length. Nothing
// where none is open.
std::optional<SnapFeel> snapFeel(const SnapRequest& request, const HalfEdgeMesh& mesh,
                                 std::span<const BoundaryLoop> loops, const FidelityValues& values, Progress progress);

}  // namespace handwheel
