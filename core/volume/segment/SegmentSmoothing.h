// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/segment/Segment.h"

namespace handwheel {

// Applies a median filter over 3³ samples to a segment. The samples at the border of the image are repeated beyond it.
// Isolated samples vanish, and steps of one sample are smoothed. Runs on all threads of the arena. O(samples), with two
// bytes of memory per sample. The result must not be used if the function was cancelled.
Segment smoothed(const ImageVolume& image, const Segment& segment, const Progress& progress = {});

}  // namespace handwheel
