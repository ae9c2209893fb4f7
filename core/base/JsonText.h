// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Parses untrusted JSON. Nesting deeper than kDeepestJson is rejected, so that no recursion over the result can
// overflow the stack. Errors: ElementMalformed {element, what is wrong}.
inline constexpr int kDeepestJson = 100;
Result<nlohmann::json> parseJson(std::string_view text, std::string_view element);

// Returns the unsigned integer under a key of an object, or 0 if it is missing or not an object.
std::uint64_t countAt(const nlohmann::json& object, const char* key);
// Returns the string under a key of an object, or `otherwise` if it is missing or not an object.
std::string stringAt(const nlohmann::json& object, const char* key, std::string otherwise = {});
// Returns at most `most` of the numbers in the array under a key of an object. Empty if it is missing.
std::vector<double> numbersAt(const nlohmann::json& object, const char* key, std::size_t most);

}  // namespace handwheel
