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

// Deepest nesting of JSON that parseJson() accepts.
inline constexpr int kDeepestJson = 100;
// Parses untrusted JSON. Nesting deeper than kDeepestJson is rejected, so that no recursion over the result can
// overflow the stack. Errors: ElementMalformed {element, what is wrong}.
Result<nlohmann::json> parseJson(std::string_view text, std::string_view element);

// Returns the unsigned integer under a key of an object. Returns 0 if the value is missing or of another type.
std::uint64_t countAt(const nlohmann::json& object, const char* key);
// Returns the string under a key of an object. Returns `otherwise` if the value is missing or of another type.
std::string stringAt(const nlohmann::json& object, const char* key, std::string otherwise = {});
// Returns at most `most` of the numbers in the array under a key of an object. The result is empty if the array is
// missing.
std::vector<double> numbersAt(const nlohmann::json& object, const char* key, std::size_t most);

}  // namespace handwheel
