// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Body.h"

namespace handwheel {

class Viewport;

// Whether a body is visible from the camera, or from its goal during a flight.
enum class BodyVisibility {
  Seen,
  Covered,  // by other parts
  Outside,  // of the view, or the body has no surface
};

// Looks at some points of the surface. Parts that cannot be searched yet cover nothing.
BodyVisibility visibilityOf(const Body& body, const Viewport& view);

}  // namespace handwheel
