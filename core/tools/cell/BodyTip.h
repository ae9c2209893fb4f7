// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Body.h"

#include <optional>

namespace handwheel {

// Returns the tip of a tool that a link carries. It is given in the frame of that link, as the middle of the farthest
// face, edge or point along z. Nothing if the body has no points. O(points).
std::optional<Vec3> tipOf(const Body& body);

}  // namespace handwheel
