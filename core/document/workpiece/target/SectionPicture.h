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
// The axis is horizontal, and z points to the right. The common area is grey, material left over the target is blue,
// and areas that were cut too deep are red; the outline of the target is black. target: the half section of the target
// as a polygon of (r, z), mm; if it is empty, the whole part is grey. May be called on any thread. O(samples).
QImage sectionPicture(const TurnedProfile& part, std::span<const ProfilePoint> target);

// Returns the half section of a target as a polygon for sectionPicture(), with arcs as lines.
std::vector<ProfilePoint> halfSectionOf(const TargetProfile& target);

// Returns a picture of a target in section in its bar, whose position is in the coordinates of the target.
QImage targetInBar(const StockCylinder& stock, const TargetProfile& target);

}  // namespace handwheel
