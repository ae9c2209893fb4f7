// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/clay/ClayStamp.h"

#include <array>
#include <string>
#include <vector>

namespace handwheel {

// The stamps that a clay tool offers: the built-in ones, and those that were loaded. Window thread.
class ClayStamps {
 public:
  // Names of the choices in the setting; the first means no stamp. English, context "Property", or the names of files.
  std::vector<std::string> names() const;
  std::size_t count() const { return 1 + kBuiltInStamps + m_loaded.size(); }
  // Returns a stamp by its index in names(); null: no stamp. Each built-in stamp is made on its first use.
  std::shared_ptr<const ClayStamp> at(std::size_t number) const;
  // Adds a stamp, or replaces the one that was loaded under this name. Returns its index.
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
