// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "machining/force/CutWarnings.h"
#include "machining/force/CuttingFeel.h"
#include "machining/force/training/NetworkTraining.h"

namespace handwheel {

// The operation "train": trains a model of cutting forces on a table of cuts.
const Operation& trainOperation();
TrainingOptions trainingOptionsOf(const OperationValues& values);

// Returns the description of 'force': the forces of a cut by each law.
const Operation& forceOperation();
// Returns the missing values as a clause; empty if none is missing.
std::string problemOfForceValues(const OperationValues& values);
CutConditions cutOf(const OperationValues& values);
CuttingEdge edgeOf(const OperationValues& values);
ThrustSettings thrustOf(const OperationValues& values);

// Returns the work that bends: null if it is not given.
std::optional<SlenderWork> slenderWorkOf(const OperationValues& values);
SpindleDrive driveOf(const OperationValues& values);

}  // namespace handwheel
