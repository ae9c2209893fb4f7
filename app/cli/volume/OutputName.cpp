// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/volume/OutputName.h"

#include "document/formats/MeshTextValues.h"

#include <algorithm>

namespace handwheel {

bool hasOneOf(const std::filesystem::path& path, const std::vector<std::string>& endings) {
  const std::string own = path.extension().string();
  return std::any_of(endings.begin(), endings.end(),
                     [&](const std::string& ending) { return equalsIgnoringCase(own, ending); });
}

}  // namespace handwheel
