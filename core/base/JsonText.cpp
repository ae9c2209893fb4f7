// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/JsonText.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

// Returns the nesting depth of brackets outside strings, also for text that is not JSON.
int depthOf(std::string_view text) {
  int depth = 0, deepest = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString && c == '\\')
      ++i;
    else if (c == '"')
      inString = !inString;
    else if (!inString && (c == '[' || c == '{'))
      deepest = std::max(deepest, ++depth);
    else if (!inString && (c == ']' || c == '}'))
      --depth;
  }
  return deepest;
}

Error malformed(std::string_view element, std::string what) {
  return {ErrorCode::ElementMalformed, {std::string(element), std::move(what)}, {}, {}};
}

}  // namespace

Result<nlohmann::json> parseJson(std::string_view text, std::string_view element) {
  if (depthOf(text) > kDeepestJson) return malformed(element, "it is nested too deeply");
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    Error failure = malformed(element, "it is not JSON");
    failure.position = InputPosition::byte(error.byte);
    return failure;
  } catch (const nlohmann::json::exception&) {  // a number out of range
    return malformed(element, "it is not JSON");
  }
}

std::uint64_t countAt(const nlohmann::json& object, const char* key) {
  if (!object.is_object()) return 0;
  const auto found = object.find(key);
  return found != object.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
}

std::string stringAt(const nlohmann::json& object, const char* key, std::string otherwise) {
  if (!object.is_object()) return otherwise;
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

std::vector<double> numbersAt(const nlohmann::json& object, const char* key, std::size_t most) {
  std::vector<double> numbers;
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (found == object.end() || !found->is_array()) return numbers;
  for (const nlohmann::json& element : *found) {
    if (element.is_number() && numbers.size() < most) numbers.push_back(element.get<double>());
  }
  return numbers;
}

}  // namespace handwheel
