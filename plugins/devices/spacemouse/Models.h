// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace handwheel::spacemouse {

inline constexpr std::uint16_t kLogitech = 0x046d;
inline constexpr std::uint16_t k3Dconnexion = 0x256f;

// A known product.
struct Model {
  const char* name;
  int buttons;
  std::uint16_t vendor;
  std::uint16_t product;
};

// Finds a known product; returns null if the product is unknown or does not have six axes.
const Model* modelOf(std::uint16_t vendor, std::uint16_t product);

// Returns true if a HID device is a supported controller with six axes. It must be a multi-axis controller (usage page
// 1, usage 8) of one of the two manufacturers, and none of their mice and keypads that report the same usage. Products
// newer than this list are accepted.
bool isSixAxis(std::uint16_t vendor, std::uint16_t product, std::uint16_t usagePage, std::uint16_t usage);

}  // namespace handwheel::spacemouse
