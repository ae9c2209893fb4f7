// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"
#include "haptics/device/Device.h"

#include <functional>
#include <optional>
#include <variant>

namespace handwheel {

struct Registered;

// A command of the command line: its syntax and the function that runs it. The function returns the exit code.
struct Command {
  using OnDocuments = int (*)(const Arguments&, const DocumentKinds&);
  using OnAll = int (*)(const Arguments&, const Registered&);

  CommandSpec spec;
  std::variant<OnDocuments, OnAll> run;
  std::string (*details)(const DocumentKinds&) = nullptr;  // returns the part of the help page about kinds of documents
  bool (*needsFonts)(std::span<char* const> operands) = nullptr;  // returns true if the command draws a plot or a page
};

// A function that opens a document that comes with the program, by its name. It returns nothing if there is no such
// document, or if a file has this name.
using ShippedDocument = std::optional<OpenedFile> (*)(const std::string& name, const DocumentKinds& kinds);

// The registered kinds, commands and drivers, as far as the commands need them.
struct Registered {
  const DocumentKinds& kinds;
  std::vector<Command> commands;                                        // commands for one kind of document
  std::function<std::vector<std::unique_ptr<DeviceDriver>>()> drivers;  // creates the built-in drivers
  std::vector<ShippedDocument> shipped;                                 // one for each kind that has such documents
};

}  // namespace handwheel
