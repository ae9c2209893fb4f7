// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace handwheel {

// The limits of untrusted YAML.
struct YamlLimits {
  static constexpr std::size_t kMostBytes = 16 << 20;
  static constexpr std::size_t kMostNodes = 1'000'000;  // values, lists and maps
  static constexpr std::size_t kDeepest = 100;          // nesting of lists and maps
};

// Parses untrusted YAML: one document, into the equivalent JSON. Words without quotes and tags are numbers, true, false
// or null if they read so; all others, and the keys of maps, are texts. Aliases, which make a few lines stand for
// millions, and repeated keys are refused. O(bytes). Errors: ElementMalformed {element, problem} with the line.
Result<nlohmann::json> parseYaml(std::string_view text, std::string_view element);

}  // namespace handwheel
