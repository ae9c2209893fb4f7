// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/Migrations.h"

#include "document/Container.h"

#include <array>
#include <cassert>

namespace handwheel {

std::span<const Migration> migrations() {
  static const std::array<Migration, kContainerVersion - 1> kChain = {
      // A workpiece may have been cut: an older program would show the bar, and lose the part when it saves. A document
      // of version 1 without it is as it was.
      [](Container&) -> Status { return Done{}; },
      // A cell may hold bodies: an older program would show the robot alone, and drop their shapes when it saves. A
      // document of version 2 holds none.
      [](Container&) -> Status { return Done{}; },
  };
  return kChain;
}

Status migrate(Container& container, std::uint64_t version, std::span<const Migration> chain) {
  assert(version >= 1);
  for (std::size_t i = static_cast<std::size_t>(version - 1); i < chain.size(); ++i) {
    if (const Status done = chain[i](container); !done) return done.error();
  }
  return Done{};
}

}  // namespace handwheel
