// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellReach.h"

#include <QString>

namespace handwheel {

// Translated texts that describe inverse kinematics solutions of an arm.

// Returns the configuration as a text: "Shoulder in front, elbow up, wrist flipped".
QString configurationText(const ArmConfiguration& configuration);

// Returns the problem of a solution, which is a joint beyond its limits or a collision; empty if there is no problem.
QString problemText(const CellScene& scene, const CellIkSolution& solution);

// Returns the angle by which the tool is turned away from the pose, as a text; empty if it is not turned away.
QString turnedOffText(const CellIkSolution& solution);

// Returns a row of the list of all solutions. number: the number of the row, from 1.
QString ikSolutionText(const CellScene& scene, const CellIkSolution& solution, std::size_t number);

}  // namespace handwheel
