// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/clay/ClayStamp.h"

#include <array>
#include <string>
#include <vector>

namespace handwheel {

// The stamps that a clay tool offers: built-in and loaded ones. All functions must be called on the window thread.
class ClayStamps {
 public:
  // Returns the names of the choices in the setting; the first means no stamp. The others are English text, translated
  // in the context "Property", or the names of files.
  std::vector<std::string> names() const;
  std::size_t count() const { return 1 + kBuiltInStamps + m_loaded.size(); }
  // Returns a stamp by its index in names(), or null for no stamp. Each built-in stamp is made on its first use.
  std::shared_ptr<const ClayStamp> at(std::size_t number) const;
  // Adds a stamp, or replaces the stamp that was loaded under this name. Returns its index.
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
