// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellReach.h"

#include <QString>

namespace handwheel {

// Texts that describe inverse kinematics solutions of an arm, translated.

// Returns a text such as "Shoulder in front, elbow up, wrist flipped".
QString configurationText(const ArmConfiguration& configuration);

// Returns the problem of a solution: a joint beyond its limits, or a collision; empty if it is free.
QString problemText(const CellScene& scene, const CellIkSolution& solution);

// Returns the angle by which the tool is turned off the pose, as a text; empty if there is none.
QString turnedOffText(const CellIkSolution& solution);

// Returns a row of the list of all solutions; number: its row, from 1.
QString ikSolutionText(const CellScene& scene, const CellIkSolution& solution, std::size_t number);

}  // namespace handwheel
