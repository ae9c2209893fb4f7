// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Body.h"

namespace handwheel {

class Viewport;

// The visibility of a body from the camera. While the camera is animated, the view at the end of the animation is
// judged.
enum class BodyVisibility {
  Seen,
  Covered,  // other parts cover it
  Outside,  // it has no surface, or its surface is outside the view
};

// Returns the visibility of a body, judged by some points of its surface. Parts of the scene that cannot be searched
// yet cover nothing.
BodyVisibility visibilityOf(const Body& body, const Viewport& view);

}  // namespace handwheel
