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

// The unsigned integer under a key of an object. 0 if missing, or not an object.
std::uint64_t countAt(const nlohmann::json& object, const char* key);
// The string under a key of an object. The other text if missing, or not an object.
std::string stringAt(const nlohmann::json& object, const char* key, std::string otherwise = {});
// The numbers among the elements of an array under a key of an object, at most so many. None if missing.
std::vector<double> numbersAt(const nlohmann::json& object, const char* key, std::size_t most);

}  // namespace handwheel
