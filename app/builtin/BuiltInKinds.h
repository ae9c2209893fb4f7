// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"
#include "window/kinds/KindUi.h"

namespace handwheel {

// A kind of document with everything that the program offers for it.
struct KindRegistration {
  KindEntry entry;                     // the kind itself and its part of the window
  std::vector<Command> commands = {};  // commands of the command line for such documents only
  // The function that opens the documents of this kind that come with the program; null: there are none.
  ShippedDocument shipped = nullptr;
};

// Returns all kinds of documents of the program. New kinds are added here and nowhere else. For a file the kinds are
// tried in this order. The mesh kind accepts every file that no other kind accepts.
std::vector<KindRegistration> builtInKinds();

// The built-in kinds in the form that the window and the command line need.
struct BuiltInKinds {
  explicit BuiltInKinds(std::vector<KindRegistration> registrations);

  KindSet set;
  std::vector<Command> commands;
  std::vector<ShippedDocument> shipped;
};

}  // namespace handwheel
