// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proximity/TriangleIntersection.h"

#include <span>

namespace handwheel {

// Returns true if the faces around an edge keep their shape when it collapses. No face may flip, lose its area, or
// become a needle much thinner than those before. A face has the same index in both lists, and its moving corner comes
// first.
bool keepsShape(std::span<const TrianglePoints> before, std::span<const TrianglePoints> after);

}  // namespace handwheel
