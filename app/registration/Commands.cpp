// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration/Commands.h"

#include "cli/mesh/MeshCommands.h"

namespace handwheel {

std::vector<Command> registeredCommands() {
  return meshCommands();
}

}  // namespace handwheel
