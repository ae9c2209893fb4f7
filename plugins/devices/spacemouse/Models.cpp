// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/Models.h"

#include <algorithm>
#include <array>

namespace handwheel::spacemouse {

namespace {

constexpr Model kModels[] = {
    {"SpaceMouse Plus XT", 11, kLogitech, 0xc603},
    {"CadMan", 4, kLogitech, 0xc605},
    {"SpaceMouse Classic", 11, kLogitech, 0xc606},
    {"Spaceball 5000", 12, kLogitech, 0xc621},
    {"SpaceTraveler", 8, kLogitech, 0xc623},
    {"SpacePilot", 21, kLogitech, 0xc625},
    {"SpaceNavigator", 2, kLogitech, 0xc626},
    {"SpaceExplorer", 15, kLogitech, 0xc627},
    {"SpaceNavigator for Notebooks", 2, kLogitech, 0xc628},
    {"SpacePilot Pro", 31, kLogitech, 0xc629},
    {"SpaceMouse Pro", 27, kLogitech, 0xc62b},
    {"SpaceMouse Wireless", 2, k3Dconnexion, 0xc62e},
    {"SpaceMouse Wireless (receiver)", 2, k3Dconnexion, 0xc62f},
    {"SpaceMouse Pro Wireless", 27, k3Dconnexion, 0xc631},
    {"SpaceMouse Pro Wireless (receiver)", 27, k3Dconnexion, 0xc632},
    {"SpaceMouse Enterprise", 32, k3Dconnexion, 0xc633},
    {"SpaceMouse Compact", 2, k3Dconnexion, 0xc635},
    {"SpaceMouse Module", 2, k3Dconnexion, 0xc636},
    {"SpaceMouse Pro Wireless (Bluetooth)", 27, k3Dconnexion, 0xc638},
    {"SpaceMouse Wireless (Bluetooth)", 2, k3Dconnexion, 0xc63a},
    {"SpaceMouse", 0, k3Dconnexion, 0xc641},
    {"Universal Receiver", 27, k3Dconnexion, 0xc652},
    {"Universal Receiver", 27, k3Dconnexion, 0xc65a},
    {"Universal Receiver", 27, k3Dconnexion, 0xc65c},
};

// Mice, keypads and displays of the same manufacturers.
constexpr std::array<std::uint16_t, 13> kOthers = {0xc62c, 0xc650, 0xc651, 0xc654, 0xc655, 0xc656, 0xc657,
                                                   0xc658, 0xc659, 0xc664, 0xc665, 0xc668, 0xc640};

constexpr std::uint16_t kGenericDesktop = 1;
constexpr std::uint16_t kMultiAxisController = 8;

}  // namespace

const Model* modelOf(std::uint16_t vendor, std::uint16_t product) {
  const auto* const found = std::find_if(std::begin(kModels), std::end(kModels), [&](const Model& model) {
    return model.vendor == vendor && model.product == product;
  });
  return found == std::end(kModels) ? nullptr : found;
}

bool isSixAxis(std::uint16_t vendor, std::uint16_t product, std::uint16_t usagePage, std::uint16_t usage) {
  if (usagePage != kGenericDesktop || usage != kMultiAxisController) return false;
  if (std::find(kOthers.begin(), kOthers.end(), product) != kOthers.end()) return false;
  return vendor == k3Dconnexion || modelOf(vendor, product) != nullptr;
}

}  // namespace handwheel::spacemouse
