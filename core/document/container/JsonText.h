// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace handwheel {

// Parses JSON that nobody vouches for. What is nested deeper than kDeepestJson is refused, so that nothing that
// recurses over the result can overflow the stack. Errors: ElementMalformed {element, what is wrong}.
inline constexpr int kDeepestJson = 100;
Result<nlohmann::json> parseJson(std::string_view text, std::string_view element);

// The whole number that an object has under a key; 0 where it has none, or is no object.
std::uint64_t countAt(const nlohmann::json& object, const char* key);

}  // namespace handwheel
