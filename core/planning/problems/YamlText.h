// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace handwheel {

// The limits for untrusted YAML.
struct YamlLimits {
  static constexpr std::size_t kMostBytes = 16 << 20;
  static constexpr std::size_t kMostNodes = 1'000'000;  // values, lists and maps
  static constexpr std::size_t kDeepest = 100;          // nesting of lists and maps
};

// Parses one document of untrusted YAML into the equivalent JSON. Scalars without quotes and tags become numbers, true,
// false or null if they have this form; all others, and the keys of maps, become texts. Repeated keys are refused, and
// so are aliases, with which a few lines can represent millions. O(bytes). Errors: ElementMalformed {element, problem}
// with the line.
Result<nlohmann::json> parseYaml(std::string_view text, std::string_view element);

}  // namespace handwheel
