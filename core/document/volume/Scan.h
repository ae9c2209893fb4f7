// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageHistogram.h"

namespace handwheel {

// The CT or MR image from which a volume was made. It never changes, so the steps of the history do not contain it.
struct Scan {
  ImageVolume image;
  ImageHistogram histogram;
};

}  // namespace handwheel
