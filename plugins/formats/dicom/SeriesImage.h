// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "dicom/Series.h"
#include "volume/image/ImageFile.h"

namespace handwheel {

// Makes the image of a series of slices. Values between slices are interpolated linearly. Errors: LibraryFailed with
// the reason.
Result<ImageFile> imageOf(const Series& series, Progress progress);

}  // namespace handwheel
