// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "haptics/Device.h"

#include <functional>

namespace handwheel {

// What the program has registered, as far as the commands need it.
struct Registered {
  const DocumentKinds& kinds;
  std::function<std::vector<std::unique_ptr<DeviceDriver>>()> drivers;  // makes those of the program itself
};

// True when the first argument is a subcommand or asks for help or the version.
bool isCommand(int argc, char** argv);

// Runs it. Exit code 0: done; 2: repaired, but something is left; 1: error, told on stderr.
int runCommand(int argc, char** argv, const Registered& registered);

}  // namespace handwheel
