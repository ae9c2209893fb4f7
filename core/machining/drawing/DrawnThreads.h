// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/drawing/PartDrawing.h"
#include "machining/thread/PartThreads.h"

namespace handwheel {

// Returns the threads of a part as its drawing shows them, each once. A thread extends along the surface in which it is
// cut. base: the z of the drawing at which the lower end of the part lies, mm. O(grooves · samples).
std::vector<DrawnThread> drawnThreads(const TurnedProfile& part, const PartThreads& threads, double base);

}  // namespace handwheel
