// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace handwheel {

// Names the calling process. No other one that ran since the computer was started has the same text, in whatever
// container. Empty where the system does not say what is needed.
std::string ownProcessMark();

// Whether a process can run no more code: it has ended, or it was killed and the system has not yet let go of its
// files, which takes as long as its memory is freed, its core is dumped, or its last write reaches the disk. False
// where that cannot be known, as of another computer, and for a text that is no mark.
bool isProcessOver(const std::string& mark);

}  // namespace handwheel
