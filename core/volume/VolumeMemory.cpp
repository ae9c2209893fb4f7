// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeMemory.h"

#include "base/NumberText.h"
#include "process/SystemMemory.h"
#include "volume/VolumeErrors.h"

namespace handwheel {

namespace {

constexpr double kShareWithoutAsking = 0.25;  // share of the free memory

double memoryLeft() {
  return static_cast<double>(systemMemory());
}

// Returns an error of a code with these arguments.
Error errorOf(const ErrorDescription& code, double voxel, double bytes) {
  return {code, {roundedText(voxel), roundedText(bytes / 1e6, 3), roundedText(memoryLeft() / 1e6, 3)}, {}, {}};
}

}  // namespace

std::optional<Error> memoryRefusal(double voxel, double bytes) {
  if (bytes <= memoryLeft()) return std::nullopt;
  return errorOf(VolumeErrors::TooLarge, voxel, bytes);
}

bool needsConsent(double bytes) {
  return !(bytes <= kShareWithoutAsking * memoryLeft());
}

std::optional<Error> consentRefusal(double voxel, double bytes, bool isAgreed) {
  if (isAgreed || !needsConsent(bytes)) return std::nullopt;
  if (auto refusal = memoryRefusal(voxel, bytes)) return refusal;
  return errorOf(VolumeErrors::NeedsConsent, voxel, bytes);
}

std::optional<Error> VolumeGrowth::refusalAt(double bytes) {
  const double growth = bytes - m_bytes;
  if (!(growth >= kBetweenLooks)) return std::nullopt;
  m_bytes = bytes;
  return memoryRefusal(m_voxel, growth);
}

}  // namespace handwheel
