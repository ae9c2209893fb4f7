// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/drawing/PartDrawing.h"
#include "machining/thread/PartThreads.h"

namespace handwheel {

// Returns the threads of a part as its drawing shows them, each once. Each extends along the surface that it is cut in.
// base: mm, height of the lower end of the part on the drawing. O(grooves · samples).
std::vector<DrawnThread> drawnThreads(const TurnedProfile& part, const PartThreads& threads, double base);

}  // namespace handwheel
