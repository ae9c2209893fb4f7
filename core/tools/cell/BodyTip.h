// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Body.h"

#include <optional>

namespace handwheel {

// The tip of a tool that a link carries, in the frame of that link. It is the middle of what reaches farthest along z:
// of a face, of an edge, or the point itself. None: the body has no points. O(points).
std::optional<Vec3> tipOf(const Body& body);

}  // namespace handwheel
