// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Property.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <optional>

namespace handwheel {

// An editable field of a workpiece.
enum class WorkpieceField { Diameter, Length, Position, Chord, Material };
inline constexpr WorkpieceField kWorkpieceFields[] = {WorkpieceField::Diameter, WorkpieceField::Length,
                                                      WorkpieceField::Position, WorkpieceField::Chord,
                                                      WorkpieceField::Material};

// The property that shows a field, with its present value.
Property propertyOf(const WorkpieceSnapshot& workpiece, WorkpieceField field);
// The field with a property id; none for unknown ids.
std::optional<WorkpieceField> fieldNamed(std::string_view id);

// Checks whether a value is valid for a field. Errors: ElementMalformed {id, what was expected}, ValueOutOfRange.
Status checkValue(WorkpieceField field, const PropertyValue& value);

// Whether a field is a size of the bar, which cannot change any more once something was cut from it.
bool isOfTheBar(WorkpieceField field);
// Whether a field belongs to an exercise while the workpiece is work on one: the bar, where it is, and its material.
bool isOfAnExercise(WorkpieceField field);

// Returns the workpiece with another value of a field, which must have been checked.
WorkpieceSnapshot withValue(WorkpieceSnapshot workpiece, WorkpieceField field, const PropertyValue& value);

// A material that the program knows, as the language of the window calls it, and back; other texts as they are. Files
// have the English name.
std::string materialInWords(const std::string& name);
std::string materialOfWords(const std::string& words);

// The properties of all fields, and those derived from them.
std::vector<Property> workpieceProperties(const WorkpieceSnapshot& workpiece);

}  // namespace handwheel
