// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/target/TargetProfile.h"

#include <QImage>
#include <span>
#include <vector>

namespace handwheel {

// Returns a picture, to scale, of a turned part and its target in section.
//
// The axis is horizontal, z to the right. Grey is the common area, blue is left over the target, red was cut too deep;
// the outline of the target is black. target: its half section as a polygon of (r, z), mm; empty: no target, the whole
// part is grey. Any thread; O(samples).
QImage sectionPicture(const TurnedProfile& part, std::span<const ProfilePoint> target);

// Returns the outline of a target as such a polygon, with arcs as lines.
std::vector<ProfilePoint> halfSectionOf(const TargetProfile& target);

// Returns a picture of a target in section in its bar, whose position is in the coordinates of the target.
QImage targetInBar(const StockCylinder& stock, const TargetProfile& target);

}  // namespace handwheel
