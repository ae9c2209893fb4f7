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

// Watches a volume that grows while it is worked on, by no more than the system has left.
class VolumeGrowth {
 public:
  static constexpr double kBetweenLooks = 64e6;  // bytes of growth; a look reads a file of the system

  // bytes: what it takes before. voxel: mm.
  VolumeGrowth(double voxel, double bytes) : m_voxel(voxel), m_bytes(bytes) {}

  // What it takes now; to be called often. The error where the system does not have as much again left as it has grown
  // by since the last look: VolumeErrors::TooLarge.
  std::optional<Error> refusalAt(double bytes);

 private:
  double m_voxel;
  double m_bytes;  // at the last look
};

}  // namespace handwheel
