// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/Buttons.h"

#include <algorithm>
#include <iterator>

namespace handwheel::spacemouse {

namespace {

struct HighButton {
  std::uint16_t number;
  int bit;
};

constexpr HighButton kHigh[] = {
    {35, 6},    // Enter
    {36, 7},    // Delete
    {76, 9},    // 11
    {77, 11},   // 12
    {102, 27},  // V1
    {103, 28},  // V2
    {104, 29},  // V3
    {174, 30},  // Tab
    {175, 31},  // Space
};

}  // namespace

int bitOf(std::uint16_t number) {
  if (number < 32) return number;
  const auto* const found =
      std::find_if(std::begin(kHigh), std::end(kHigh), [&](const HighButton& high) { return high.number == number; });
  return found == std::end(kHigh) ? kNoBit : found->bit;
}

}  // namespace handwheel::spacemouse
