// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace handwheel::spacemouse {

inline constexpr std::uint16_t kLogitech = 0x046d;
inline constexpr std::uint16_t k3Dconnexion = 0x256f;

struct Model {
  const char* name;
  int buttons;
  std::uint16_t vendor;
  std::uint16_t product;
};

// What is known of a product; null for one that is not known, or that has no six axes.
const Model* modelOf(std::uint16_t vendor, std::uint16_t product);

// Whether such a device is ours: one of the two makers, a multi-axis controller (usage page 1, usage 8), and none of
// the mice and keypads that say so, too. Products that came later than this list are taken.
bool isSixAxis(std::uint16_t vendor, std::uint16_t product, std::uint16_t usagePage, std::uint16_t usage);

}  // namespace handwheel::spacemouse
