// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace handwheel {

// What untrusted YAML may have at most.
struct YamlLimits {
  static constexpr std::size_t kMostBytes = 16 << 20;
  static constexpr std::size_t kMostNodes = 1'000'000;  // values, lists, maps
  static constexpr std::size_t kDeepest = 100;          // lists and maps in each other
};

// Parses untrusted YAML: one document, as the same in JSON. Words without quotes and tags are numbers, true, false or
// null where they read so; all others, and the keys of maps, are texts. Aliases, which make a few lines stand for
// millions, and keys that are there twice are refused. O(bytes). Errors: ElementMalformed {element, what is wrong} with
// the line.
Result<nlohmann::json> parseYaml(std::string_view text, std::string_view element);

}  // namespace handwheel
