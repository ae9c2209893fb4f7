// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proximity/TriangleIntersection.h"

#include <span>

namespace handwheel {

// Whether the faces around an edge keep their shape when it collapses. No face turns over, loses its area, or becomes a
// needle much thinner than those that were there. In both lists a face has the same index, and the corner that moves
// comes first.
bool keepsShape(std::span<const TrianglePoints> before, std::span<const TrianglePoints> after);

}  // namespace handwheel
