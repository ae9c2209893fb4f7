// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <optional>

namespace handwheel {

// VolumeErrors::TooLarge where the system has less memory left than voxels of this edge, mm, are going to take.
std::optional<Error> memoryRefusal(double voxel, double bytes);

}  // namespace handwheel
