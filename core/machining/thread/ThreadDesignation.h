// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/thread/ThreadCut.h"

#include <string>

namespace handwheel {

// Returns the designation of a measured thread, by its major diameter. The diameter is in mm; for a bore, at the roots:
// "M20×2.5", "M20×L5P2.5-LH" (ISO 965-1), "Tr40×14P7LH" (ISO 2904). The nominal diameter is the one of ISO 261 whose
// tolerance (ISO 965-1, up to grade 8) contains the measured one, else the measured one to 0.01 mm. Other profiles have
// diameter, pitch and angle.
std::string threadDesignation(const ThreadCut& cut, double major, bool isInner);

}  // namespace handwheel
