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
//   solids N                        the shape has N solids or shells instead of one
//   no-axis                         no face of the shape is a surface of revolution
//   face N KIND X Y Z               face N is not a surface of revolution; X Y Z is a point on it
//   turned IGNORED                  number of ignored faces; followed by one line for each face:
//     line R Z R Z                  meridian of the face, mm: the ends of a line
//     arc R Z R Z R Z               start, a point between, and end of an arc
//     points N R Z ...              N points on another curve
//
// Faces are numbered from 1 in the order of the shape. isLenient: true if faces that are not surfaces of revolution,
// such as cross holes, are ignored and counted. May throw Standard_Failure.
std::string turnedAnswer(const TopoDS_Shape& shape, bool isLenient);

}  // namespace handwheel
