// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/thread/ThreadCut.h"

#include <string>

namespace handwheel {

// Returns the designation of a measured thread. major: the major diameter, mm, which is the diameter at the roots in a
// bore. Examples are "M20×2.5", "M20×L5P2.5-LH" (ISO 965-1) and "Tr40×14P7LH" (ISO 2904). The nominal diameter is the
// diameter of ISO 261 whose tolerance (ISO 965-1, up to grade 8) contains the measured diameter; if there is none, it
// is the measured diameter to 0.01 mm. Threads of other profiles are described by diameter, pitch and angle.
std::string threadDesignation(const ThreadCut& cut, double major, bool isInner);

}  // namespace handwheel
