// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellReach.h"

#include <QString>

namespace handwheel {

// Texts that describe inverse kinematics solutions of an arm, translated.

// "Shoulder in front, elbow up, wrist flipped".
QString configurationText(const ArmConfiguration& configuration);

// What is wrong with a solution: a joint beyond its limits, or what collides; empty: it is free.
QString problemText(const CellScene& scene, const CellIkSolution& solution);

// How far the tool is turned off the pose; empty: it is not.
QString turnedOffText(const CellIkSolution& solution);

// A row of the list of all solutions; number: of its place in it, from 1.
QString ikSolutionText(const CellScene& scene, const CellIkSolution& solution, std::size_t number);

}  // namespace handwheel
