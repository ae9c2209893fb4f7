// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/thread/ThreadCut.h"

#include <string>

namespace handwheel {

// The designation of a measured thread, by its major diameter. The diameter is in mm; of a bore, at the roots:
// "M20×2.5", "M20×L5P2.5-LH" (ISO 965-1), "Tr40×14P7LH" (ISO 2904). The nominal diameter is the one of ISO 261 within
// whose tolerance (ISO 965-1, up to grade 8) the measured one is, else that itself to 0.01 mm. Of other profiles,
// diameter, pitch and angle.
std::string threadDesignation(const ThreadCut& cut, double major, bool isInner);

}  // namespace handwheel
