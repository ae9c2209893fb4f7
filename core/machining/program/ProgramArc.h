// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/NoseCompensation.h"

namespace handwheel {

// Returns the centre of an arc from its radius. A negative radius selects the longer arc. turn: 1 counter-clockwise in
// the plane of z and r, -1 clockwise. Throws ProgramRefusal if the radius is less than half the distance of the ends.
PlanePoint centreFromRadius(const PlanePoint& from, const PlanePoint& to, int turn, double radius,
                            const SourceLocation& location);

// Checks the centre of an arc. Throws ProgramRefusal if its distances from the two ends differ by more than 0.0127 mm
// and 0.1 %, or by more than 1.27 mm.
void checkCentre(const PlanePoint& from, const PlanePoint& to, const PlanePoint& centre,
                 const SourceLocation& location);

}  // namespace handwheel
