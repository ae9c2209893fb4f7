// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/FidelityOption.h"

#include "cli/Messages.h"
#include "fidelity/MeasuredSettings.h"

#include <algorithm>

namespace handwheel {

std::string readFidelity(const Arguments& arguments, std::string_view command, std::span<const FidelitySetting> read,
                         FidelityValues& values) {
  const Result<FidelityValues> chosen = readValues(measuredSettings(), arguments.valueOf("fidelity"));
  if (!chosen) return sentenceFor(chosen.error());
  for (const auto& [id, value] : chosen->overrides()) {
    const auto isRead = [&id = id](const FidelitySetting& setting) { return setting.id == id; };
    if (std::any_of(read.begin(), read.end(), isRead)) continue;
    std::string names;
    for (const FidelitySetting& setting : read) names += (names.empty() ? "" : ", ") + setting.id;
    return "The command " + std::string(command) + " does not use the setting " + id + ", but " + names + ".";
  }
  values = *chosen;
  return {};
}

}  // namespace handwheel
