// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Property.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <optional>

namespace handwheel {

// What can be changed of a workpiece.
enum class WorkpieceField { Diameter, Length, Position, Chord, Material };
inline constexpr WorkpieceField kWorkpieceFields[] = {WorkpieceField::Diameter, WorkpieceField::Length,
                                                      WorkpieceField::Position, WorkpieceField::Chord,
                                                      WorkpieceField::Material};

// The property that shows a field, with its present value.
Property propertyOf(const WorkpieceSnapshot& workpiece, WorkpieceField field);
std::optional<WorkpieceField> fieldNamed(std::string_view id);

// Whether a field can have a value. Errors: ElementMalformed {id, what was expected}, ValueOutOfRange.
Status checkValue(WorkpieceField field, const PropertyValue& value);

// The same workpiece with another value, which has been checked.
WorkpieceSnapshot withValue(WorkpieceSnapshot workpiece, WorkpieceField field, const PropertyValue& value);

// Those of all fields, and what follows from them.
std::vector<Property> workpieceProperties(const WorkpieceSnapshot& workpiece);

}  // namespace handwheel
