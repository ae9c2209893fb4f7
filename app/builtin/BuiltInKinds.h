// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"
#include "window/kinds/KindUi.h"

namespace handwheel {

// A kind of document with everything that the program has for it.
struct KindRegistration {
  KindEntry entry;                     // the kind itself and its part of the window
  std::vector<Command> commands = {};  // command line commands for such documents only
  ShippedDocument shipped = nullptr;   // creates the documents of this kind that come with the program; null: none do
};

// Returns all kinds of documents of the program. New kinds are added here and nowhere else. They are tried in this
// order for a file; meshes accept all files that no other kind accepts.
std::vector<KindRegistration> builtInKinds();

// The built-in kinds in the form that the window and the command line need.
struct BuiltInKinds {
  explicit BuiltInKinds(std::vector<KindRegistration> registrations);

  KindSet set;
  std::vector<Command> commands;
  std::vector<ShippedDocument> shipped;
};

}  // namespace handwheel
