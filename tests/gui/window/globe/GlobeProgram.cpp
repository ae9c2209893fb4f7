// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "builtin/Drivers.h"
#include "cli/CommandLine.h"
#include "globe/GlobeRegistration.h"

// The command line of the program as it would be with one kind more.
int main(int argc, char** argv) {
  using namespace handwheel;
  const BuiltInKinds kinds(test::kindsWithGlobe());
  return runCommand(argc, argv, {kinds.set.documents, kinds.commands, registeredDrivers, kinds.shipped});
}
