// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/Recording.h"

#include <string>

namespace handwheel {

// A haptic recording that is stored in a document. Copies share the ticks.
struct StoredRecording {
  std::string key;          // four digits or more, unique in the document, never changes
  std::string name;         // chosen by the user
  std::string device;       // the name of the device; empty: unknown
  double forceLimit = 0.0;  // limit of the device, N in the scene; 0: unknown
  Recording ticks;
};

}  // namespace handwheel
