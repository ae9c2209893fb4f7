// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/Recording.h"
#include "machining/TurningPass.h"

#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// Returns the text that describes a turning tool in a recording. For example, “turn bore nose 0.8 poles 0.5” means a
// bore, a nose of 0.8 mm, and control points every 0.5 mm. blank: a pass of the tool without points.
std::string recordedTurning(const TurningPass& blank);

// Returns the passes of the turning tool in a recording that was made in the window. There is one for each press of the
// first button while the tool was in use, with the settings at that time. If the recording has no settings, the outside
// was turned with a nose of 1 mm. The path of a pass is that of the proxy, at which the window displayed the tip. A
// pass ends when the button is released or the tip leaps, as it does in the window; passes that were cancelled with Esc
// are included. base: mm, z of the lower end of the part. Returns nothing if the manual lathe was in use: its levers
// and handwheels are not recorded.
std::optional<std::vector<TurningPass>> passesOf(const Recording& recording, double base);

}  // namespace handwheel
