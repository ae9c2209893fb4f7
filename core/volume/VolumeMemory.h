// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <optional>

namespace handwheel {

// Returns an error if a volume needs more memory than the system has left: VolumeErrors::TooLarge. voxel: mm.
std::optional<Error> memoryRefusal(double voxel, double bytes);

// Returns true if a volume of so many bytes needs the user's consent: it takes more than a quarter of the free memory.
bool needsConsent(double bytes);

// Returns an error if the volume needs consent that was not given: VolumeErrors::NeedsConsent, or TooLarge if it
// exceeds the free memory. As a prediction may be too high, with consent only the volume itself is refused, once it is
// too large.
std::optional<Error> consentRefusal(double voxel, double bytes, bool isAgreed);

// Limits the growth of a volume that is being edited to the memory that the system has left.
class VolumeGrowth {
 public:
  static constexpr double kBetweenLooks =
      64e6;  // bytes of growth between two checks; a check reads a file of the system

  // voxel: mm. bytes: the initial size of the volume.
  VolumeGrowth(double voxel, double bytes) : m_voxel(voxel), m_bytes(bytes) {}

  // Takes the present size in bytes; to be called often. Returns VolumeErrors::TooLarge if the system has less memory
  // left than the volume has grown by since the last check.
  std::optional<Error> refusalAt(double bytes);

 private:
  double m_voxel;
  double m_bytes;  // size at the last check
};

}  // namespace handwheel
