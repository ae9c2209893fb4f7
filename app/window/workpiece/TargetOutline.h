// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/TargetProfile.h"
#include "viewport/camera/CameraState.h"
#include "viewport/path/PathLayer.h"

namespace handwheel {

// Returns the plane through the axis that faces the viewer best. It is a number of steps of 15° about the axis. If the
// viewer looks along the axis, all planes are alike.
int outlineStep(const CameraState& camera);

// Returns the outline of a target in that plane, on both sides of the axis, with rings at its corners, which are seen
// from anywhere. A curve of many lines has rings at some of them.
PathLayer::Lines targetOutline(const TargetProfile& target, int step);

}  // namespace handwheel
