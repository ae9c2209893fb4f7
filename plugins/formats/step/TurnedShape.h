// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <TopoDS_Shape.hxx>
#include <string>

namespace handwheel {

// Finds the axis of a turned part and its half section. The answer for core/machining/target/ProfileFromStep.cpp
// consists of lines of text:
//
//   solids N                        the shape is not one solid
//   no-axis                         nothing in it turns
//   face N KIND X Y Z               this face is not of revolution; a point on it
//   turned IGNORED, then for each face a line of:
//     line R Z R Z                  its meridian, mm
//     arc R Z R Z R Z               from, over, to
//     points N R Z ...              on another curve
//
// Faces are numbered from 1 in the order of the shape. isLenient: faces that are not of revolution, such as cross
// holes, are ignored and counted. May throw Standard_Failure.
std::string turnedAnswer(const TopoDS_Shape& shape, bool isLenient);

}  // namespace handwheel
