// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/NoseCompensation.h"

namespace handwheel {

// The centre of an arc from its radius. Of the shorter arc, or of the longer one where the radius is negative. turn: 1
// counter-clockwise in the plane of z and r, -1 clockwise. Refuses a radius that does not reach (ProgramRefusal).
PlanePoint centreFromRadius(const PlanePoint& from, const PlanePoint& to, int turn, double radius,
                            const ProgramPlace& place);

// Refuses a centre that is not as far from both ends: by more than 0.0127 mm and 0.1 %, or by more than 1.27 mm.
void checkCentre(const PlanePoint& from, const PlanePoint& to, const PlanePoint& centre, const ProgramPlace& place);

}  // namespace handwheel
