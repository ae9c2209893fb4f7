// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/segment/Segment.h"

namespace handwheel {

// The median filter of a segment over 3³ samples. A sample is in it where most around are, those at the border counting
// for the ones beyond. Specks of one sample vanish, steps of one are evened. On all threads of the arena; O(samples),
// and two bytes for each. After a cancel the result is not to be used.
Segment smoothed(const ImageVolume& image, const Segment& segment, const Progress& progress = {});

}  // namespace handwheel
