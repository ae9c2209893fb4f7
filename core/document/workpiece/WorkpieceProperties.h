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

// Returns the property that shows a field, with its present value.
Property propertyOf(const WorkpieceSnapshot& workpiece, WorkpieceField field);
// Returns the field with a property id. Returns nothing for unknown ids.
std::optional<WorkpieceField> fieldNamed(std::string_view id);

// Checks a value for a field. Errors: ElementMalformed {id, what was expected}, ValueOutOfRange.
Status checkValue(WorkpieceField field, const PropertyValue& value);

// Returns true if a field is a size of the bar, which is fixed once the bar is cut.
bool isOfTheBar(WorkpieceField field);
// Returns true if a field is fixed by the exercise that the workpiece is work on: the size of the bar, its position and
// its material.
bool isOfAnExercise(WorkpieceField field);

// Returns the workpiece with another value of a field, which must have passed checkValue().
WorkpieceSnapshot withValue(WorkpieceSnapshot workpiece, WorkpieceField field, const PropertyValue& value);

// Translate the name of a known material from English, as in files, to the language of the window, and back. Other
// texts are returned unchanged.
std::string materialInWords(const std::string& name);
std::string materialOfWords(const std::string& words);

// Returns the properties of all fields, and properties derived from them.
std::vector<Property> workpieceProperties(const WorkpieceSnapshot& workpiece);

}  // namespace handwheel
