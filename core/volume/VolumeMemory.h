// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <optional>

namespace handwheel {

// The error where a volume needs more memory than the system has left. VolumeErrors::TooLarge for voxels of this edge,
// mm.
std::optional<Error> memoryRefusal(double voxel, double bytes);

}  // namespace handwheel
