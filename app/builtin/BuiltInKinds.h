// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"
#include "window/kinds/KindUi.h"

namespace handwheel {

// A kind of document with all that the program has for it.
struct KindRegistration {
  KindEntry entry;                     // the kind itself and its part of the window
  std::vector<Command> commands = {};  // of the command line, for such documents only
  ShippedDocument shipped = nullptr;   // those that come with the program; null: none do
};

// All kinds of documents of the program. The one place to add further ones. They are asked in this order whether a file
// is theirs; meshes take what no other kind takes.
std::vector<KindRegistration> builtInKinds();

// The built-in kinds as window and command line take them.
struct BuiltInKinds {
  explicit BuiltInKinds(std::vector<KindRegistration> registrations);

  KindSet set;
  std::vector<Command> commands;
  std::vector<ShippedDocument> shipped;
};

}  // namespace handwheel
