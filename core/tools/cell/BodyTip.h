// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Body.h"

#include <optional>

namespace handwheel {

// Returns the tip of a tool that a link carries. The tip is the middle of the face, edge or point that is farthest
// along the z axis of the link, in the frame of the link. Returns nothing if the body has no points. O(points).
std::optional<Vec3> tipOf(const Body& body);

}  // namespace handwheel
