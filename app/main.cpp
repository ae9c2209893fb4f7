// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "builtin/BuiltInKinds.h"
#include "builtin/Drivers.h"
#include "builtin/PluginPosts.h"
#include "cli/CommandLine.h"
#include "window/RunWindow.h"

// A first argument that names a subcommand runs without a window; anything else is a file to open in it.
int main(int argc, char** argv) {
  handwheel::setPluginPosts(handwheel::pluginPosts);
  const handwheel::BuiltInKinds kinds(handwheel::builtInKinds());
  const handwheel::Registered registered{kinds.set.documents, kinds.commands, handwheel::registeredDrivers,
                                         kinds.shipped};
  if (handwheel::isCommand(argc, argv, registered)) return handwheel::runCommand(argc, argv, registered);
  return handwheel::runWindow(argc, argv, kinds.set, handwheel::registeredDrivers());
}
