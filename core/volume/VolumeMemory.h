// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <optional>

namespace handwheel {

// Returns the error VolumeErrors::TooLarge if a volume needs more memory than the system has left. voxel: mm.
std::optional<Error> memoryRefusal(double voxel, double bytes);

// Returns true if a volume of this size needs the user's consent, as it takes more than a quarter of the free memory.
bool needsConsent(double bytes);

// Returns an error if a volume needs consent that was not given: VolumeErrors::NeedsConsent, or TooLarge if it exceeds
// the free memory. With consent, returns no error: the prediction may be too high, so the volume is refused only if it
// becomes too large while it is made.
std::optional<Error> consentRefusal(double voxel, double bytes, bool isAgreed);

// Limits the growth of a volume during editing to the memory that the system has left.
class VolumeGrowth {
 public:
  static constexpr double kBetweenLooks =
      64e6;  // bytes of growth between two checks; a check reads a file of the system

  // voxel: size of a voxel, mm. bytes: initial size of the volume.
  VolumeGrowth(double voxel, double bytes) : m_voxel(voxel), m_bytes(bytes) {}

  // Checks the current size in bytes; should be called often. Returns VolumeErrors::TooLarge if the system has less
  // memory left than the volume has grown by since the last check.
  std::optional<Error> refusalAt(double bytes);

 private:
  double m_voxel;
  double m_bytes;  // size at the last check
};

}  // namespace handwheel
