// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"

namespace handwheel {

// Removes faces that have the same three positions as another face. Duplicates that hang together are judged together:
// one of each stays, or none where the surface is closed without them (a wall inside a solid, a flap), or both where
// they are the two sides of a plate, which is closed as it is. Returns how many went. Relinks when any did.
std::size_t removeDuplicateFaces(HalfEdgeMesh& mesh);

}  // namespace handwheel
