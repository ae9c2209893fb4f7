// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "machining/force/CutWarnings.h"
#include "machining/force/CuttingFeel.h"
#include "machining/force/training/NetworkTraining.h"

namespace handwheel {

// Returns the operation "train", which trains a model of cutting forces on measured cuts.
const Operation& trainOperation();
TrainingOptions trainingOptionsOf(const OperationValues& values);

// Returns the operation "force", which calculates the forces of a cut by each law.
const Operation& forceOperation();
// Returns the missing values as a clause. The text is empty if no value is missing.
std::string problemOfForceValues(const OperationValues& values);
CutConditions cutOf(const OperationValues& values);
CuttingEdge edgeOf(const OperationValues& values);
ThrustSettings thrustOf(const OperationValues& values);

// Returns the slender work that the force bends. Returns nothing if its values are not given.
std::optional<SlenderWork> slenderWorkOf(const OperationValues& values);
SpindleDrive driveOf(const OperationValues& values);

}  // namespace handwheel
