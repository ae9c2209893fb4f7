// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellReach.h"

#include <QString>

namespace handwheel {

// Texts that describe inverse kinematics solutions of an arm, translated.

// "Shoulder in front, elbow up, wrist flipped".
QString stanceText(const ArmStance& stance);

// What is wrong with a way: a joint beyond its limits, or what collides; empty: it is free.
QString problemText(const CellScene& scene, const CellWay& way);

// A row of the list of all ways; number: of its place in it, from 1.
QString wayText(const CellScene& scene, const CellWay& way, std::size_t number);

}  // namespace handwheel
