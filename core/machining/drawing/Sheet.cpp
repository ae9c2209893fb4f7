// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/Sheet.h"

namespace handwheel {

void Sheet::arrow(const ProfilePoint& tip, const ProfilePoint& towards) {
  constexpr double kLength = 3.0, kHalfWidth = 0.5;  // mm
  const ProfilePoint along = towards.normalized(), across(-along.y(), along.x());
  const ProfilePoint back = tip - kLength * along;
  const ProfilePoint left = back + kHalfWidth * across, right = back - kHalfWidth * across;
  areas.push_back({{{tip, left, 0.0}, {left, right, 0.0}, {right, tip, 0.0}}, false});
}

double widthOf(const std::string& text, double height) {
  constexpr double kPerCharacter = 0.85;  // of the height of capitals, for a sans serif
  std::size_t characters = 0;
  for (const char c : text) characters += (static_cast<unsigned char>(c) & 0xc0) != 0x80 ? 1 : 0;
  return kPerCharacter * height * static_cast<double>(characters);
}

}  // namespace handwheel
