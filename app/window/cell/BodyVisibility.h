// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Body.h"

namespace handwheel {

class Viewport;

// The visibility of a body from the camera, or from its goal during a flight.
enum class BodyVisibility {
  Seen,
  Covered,  // Covered by other parts
  Outside,  // Outside the view, or without a surface
};

// Returns the visibility, from some points of the surface. Parts that cannot be searched yet cover nothing.
BodyVisibility visibilityOf(const Body& body, const Viewport& view);

}  // namespace handwheel
