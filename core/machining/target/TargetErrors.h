// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of target profiles. Positions are in the coordinates of the profile, mm.
namespace handwheel::TargetError {

extern const ErrorDescription CrossesAxis;      // {z}
extern const ErrorDescription TouchesAxis;      // {z}; the outline touches the axis between its ends
extern const ErrorDescription CrossesItself;    // {r, z}
extern const ErrorDescription NotJoined;        // {gap, r, z}
extern const ErrorDescription NoArea;           // the outline has no area
extern const ErrorDescription NoProfile;        // the file contains no line or arc
extern const ErrorDescription SeveralProfiles;  // {count}
extern const ErrorDescription BinaryDrawing;    // a DXF file of the binary variant
extern const ErrorDescription AxisUnknown;      // the drawing has no axis
extern const ErrorDescription NoAxis;           // no face of the solid is a surface of revolution
extern const ErrorDescription NotTurned;        // {number of the face, kind of surface, x, y, z}
extern const ErrorDescription TooIntricate;     // the segments overlap too often to be checked
extern const ErrorDescription MeshNotTurned;    // {deviation, tolerance}
extern const ErrorDescription NotOneSolid;      // {count}

}  // namespace handwheel::TargetError
