// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/Recording.h"

#include <string>

namespace handwheel {

// A haptic recording that is stored in a document. A copy shares the ticks.
struct StoredRecording {
  std::string key;          // four digits or more, unique in the document, never changes
  std::string name;         // as the user calls it
  std::string device;       // the name of the device; empty: not known
  double forceLimit = 0.0;  // N in the scene, of that device; 0: not known
  Recording ticks;
};

}  // namespace handwheel
