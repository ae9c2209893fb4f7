// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/clay/ClayStamp.h"

#include <array>
#include <string>
#include <vector>

namespace handwheel {

// The stamps that a clay tool offers: those built in, and those loaded since. Window thread.
class ClayStamps {
 public:
  // What the setting offers; the first is no stamp. English, context "Property", or the names of files.
  std::vector<std::string> names() const;
  std::size_t count() const { return 1 + kBuiltInStamps + m_loaded.size(); }
  // By its number there; null: no stamp. Those built in are made with the first use of each.
  std::shared_ptr<const ClayStamp> at(std::size_t number) const;
  // Adds one, or takes the place of one that was loaded under this name. Returns its number.
  std::size_t add(const std::string& name, std::shared_ptr<const ClayStamp> stamp);

 private:
  struct Loaded {
    std::string name;
    std::shared_ptr<const ClayStamp> stamp;
  };

  std::vector<Loaded> m_loaded;
  mutable std::array<std::shared_ptr<const ClayStamp>, kBuiltInStamps> m_builtIn;
};

}  // namespace handwheel
