// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageHistogram.h"

namespace handwheel {

// The CT or MR image that a volume was made from. It never changes, so no step of the history holds it.
struct Scan {
  ImageVolume image;
  ImageHistogram histogram;
};

}  // namespace handwheel
