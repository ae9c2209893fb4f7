// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/target/TargetProfile.h"

#include <QImage>
#include <span>
#include <vector>

namespace handwheel {

// A turned part in section over the section of its target, to scale.
//
// The axis is horizontal, z to the right. Grey is what both have, blue is left over the target, red was cut too deep;
// the outline of the target is black. target: its half section as a polygon of (r, z), mm; empty: there is none, and
// all of the part is grey. Any thread; O(samples).
QImage sectionPicture(const TurnedProfile& part, std::span<const ProfilePoint> target);

// The outline of a target as such a polygon, arcs as lines.
std::vector<ProfilePoint> halfSectionOf(const TargetProfile& target);

// A target in section in its bar, whose place is in the coordinates of the target.
QImage targetInBar(const StockCylinder& stock, const TargetProfile& target);

}  // namespace handwheel
