// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeMemory.h"

#include "base/NumberText.h"
#include "process/SystemMemory.h"
#include "volume/VolumeErrors.h"

namespace handwheel {

std::optional<Error> memoryRefusal(double voxel, double bytes) {
  const auto left = static_cast<double>(systemMemory());
  if (bytes <= left) return std::nullopt;
  return Error{
      VolumeErrors::TooLarge, {roundedText(voxel), roundedText(bytes / 1e6, 3), roundedText(left / 1e6, 3)}, {}, {}};
}

}  // namespace handwheel
