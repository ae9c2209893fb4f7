// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/Recording.h"
#include "machining/TurningPass.h"

#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// Returns the text in a recording that describes its turning tool. blank: a pass of that tool without points. “turn
// bore nose 0.8 poles 0.5”: a bore, a nose of 0.8 mm, and control points every 0.5 mm.
std::string recordedTurning(const TurningPass& blank);

// Returns the passes of the turning tool in a recording of the window. There is one for each press of the first button
// while the tool was in use, with the settings at that time; a recording without settings is of the outside, with a
// nose of 1 mm. The nose was at the displayed tip, its proxy. A pass ends with the button, or where the tip leaps, as
// in the window; passes that were cancelled with Esc are included. base: mm, z of the lower end of the part. None if
// the manual lathe was in use: its levers and handwheels are not recorded.
std::optional<std::vector<TurningPass>> passesOf(const Recording& recording, double base);

}  // namespace handwheel
