// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GlobeCommand.h"
#include "cli/CommandLine.h"
#include "registration/Drivers.h"

// The command line of the program as it would be with one kind more.
int main(int argc, char** argv) {
  using namespace handwheel;
  std::vector<KindRegistration> all = registeredKinds();
  all.insert(all.begin(), test::globeRegistration({}));
  const RegisteredKinds kinds(std::move(all));
  return runCommand(argc, argv, {kinds.set.documents, kinds.commands, registeredDrivers});
}
