// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <string>

namespace handwheel {

// Checks every invariant of the half-edge mesh. Returns a description of the first violation, or an empty string. The
// function is used for meshes from files and in tests. If cancelled, the returned string says so. O(n). The invariants
// are:
//  - corners of live faces are vertices in range with finite positions; dead faces have no neighbours;
//  - opposites are mutual, have the same two vertices in reverse order, and join proper live faces;
//  - a vertex has exactly one fan of proper faces.
std::string validate(const HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
