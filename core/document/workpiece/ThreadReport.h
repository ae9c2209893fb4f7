// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/drawing/PartDrawing.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace handwheel {

// Z counts in the document. The lower end of the bar is at `position`, mm. The range of a thread is that of the groove
// in the material, without the approach and the runout of the tool.

// Returns the threads of a part as text, by pitch and Z range. Example: "pitch 2.5 mm, Z 10 to 40; …".
std::string threadsText(const TurnedPart& part, double position);

// Returns the threads as an array of objects with "from", "to" (mm), "pitch", "starts", "hand", "inner", and the values
// that gauges would measure: "measured_pitch", "major_diameter", "pitch_diameter", "minor_diameter" (null if not
// found).
nlohmann::json threadsJson(const TurnedPart& part, double position);

// Returns the threads of a workpiece as its drawing and its dimensions in the view have them. O(samples · grooves).
std::vector<DrawnThread> threadsToDraw(const WorkpieceSnapshot& workpiece);

}  // namespace handwheel
