// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "process/SystemMemory.h"

#include <fstream>
#include <limits>
#include <string>

namespace handwheel {

std::size_t systemMemory() {
  std::ifstream statistics("/proc/meminfo");
  std::size_t kibibytes = 0, sum = 0;
  std::string name, rest;
  bool isKnown = false;
  while (statistics >> name >> kibibytes && std::getline(statistics, rest)) {
    if (name != "MemAvailable:" && name != "SwapFree:") continue;
    isKnown = isKnown || name == "MemAvailable:";
    sum += kibibytes << 10;
  }
  return isKnown ? sum : std::numeric_limits<std::size_t>::max();
}

}  // namespace handwheel
