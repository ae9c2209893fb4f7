// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <optional>

namespace handwheel {

// The error where a volume needs more memory than the system has left. VolumeErrors::TooLarge for voxels of this edge,
// mm.
std::optional<Error> memoryRefusal(double voxel, double bytes);

// Whether a volume that needs so many bytes is made only after asking: it takes more than a quarter of what is left.
bool needsConsent(double bytes);

// The error where that is so and nobody has agreed: VolumeErrors::NeedsConsent, or TooLarge where it is more than there
// is. What is predicted may be too much: whoever insists is refused only where the volume itself turns out too large.
std::optional<Error> consentRefusal(double voxel, double bytes, bool isAgreed);

}  // namespace handwheel
