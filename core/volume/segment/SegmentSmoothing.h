// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/segment/Segment.h"

namespace handwheel {

// Applies a median filter over 3³ samples to a segment. Beyond the border of the image its samples are repeated.
// Isolated samples vanish, and steps of one sample are smoothed. On all threads of the arena; O(samples), and two bytes
// of memory for each. The result must not be used if cancelled.
Segment smoothed(const ImageVolume& image, const Segment& segment, const Progress& progress = {});

}  // namespace handwheel
