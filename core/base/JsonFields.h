// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace handwheel {

// Reader and writer of the members of a JSON object. Both use the same list of keys:
//
//   template <class Chuck, class Visitor>
//   void visitFields(Chuck& chuck, const Visitor& visit) {
//     visit("diameter", chuck.diameter);
//     …
//   }

// Writes each field to the member of a JSON object with the same key.
class JsonFieldWriter {
 public:
  explicit JsonFieldWriter(nlohmann::json& object) : m_object(object) {}

  template <class Value>
  void operator()(const char* key, const Value& value) const {
    m_object[key] = value;
  }

 private:
  nlohmann::json& m_object;
};

// Reads each field from the member of a JSON object with the same key. A field stays unchanged if its member is missing
// or has the wrong type. The JSON value need not be an object.
class JsonFieldReader {
 public:
  explicit JsonFieldReader(const nlohmann::json& object) : m_object(object) {}

  void operator()(const char* key, double& value) const {
    if (const nlohmann::json& found = member(key); found.is_number()) value = found.get<double>();
  }
  void operator()(const char* key, int& value) const {
    const nlohmann::json& found = member(key);
    if (found.is_number_integer() && std::abs(found.get<double>()) < 1e9) value = found.get<int>();
  }
  void operator()(const char* key, bool& value) const {
    if (const nlohmann::json& found = member(key); found.is_boolean()) value = found.get<bool>();
  }
  void operator()(const char* key, std::string& value) const {
    if (const nlohmann::json& found = member(key); found.is_string()) value = found.get<std::string>();
  }
  // Returns the member with this key, or null if it does not exist.
  const nlohmann::json& member(const char* key) const {
    static const nlohmann::json kNothing;
    if (!m_object.is_object()) return kNothing;
    const auto found = m_object.find(key);
    return found == m_object.end() ? kNothing : *found;
  }

 private:
  const nlohmann::json& m_object;
};

}  // namespace handwheel
