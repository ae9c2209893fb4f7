// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/problems/YamlText.h"

#include "base/NumberText.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <vector>

namespace handwheel {

namespace {

using Json = nlohmann::json;

// Thrown out of the parser, which cannot be stopped otherwise.
class RefusedYaml : public YAML::ParserException {
 public:
  using YAML::ParserException::ParserException;
};

// Builds the value from the events of the parser, with bounded depth and size.
class JsonOfYaml : public YAML::EventHandler {
 public:
  JsonOfYaml() = default;
  JsonOfYaml(const JsonOfYaml&) = delete;
  JsonOfYaml& operator=(const JsonOfYaml&) = delete;

  Json takeValue() { return std::move(m_value).value_or(Json()); }
  bool isThere() const { return m_nodes > 0; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (isThere()) throw RefusedYaml(mark, "it has more than one document");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { add(mark, nullptr); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    throw RefusedYaml(mark, "aliases are not supported");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t, const std::string& word) override {
    const bool isPlain = tag == "?";
    if (isKeyNext()) {
      m_open.back().key = word;
      count(mark);
    } else {
      add(mark, isPlain ? meaningOf(word) : Json(word));
    }
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    open(mark, Json::array());
  }
  void OnSequenceEnd() override { m_open.pop_back(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    open(mark, Json::object());
  }
  void OnMapEnd() override { m_open.pop_back(); }

 private:
  // A list or map that is being filled; for a map with the key of the next value.
  struct Open {
    Json* value;
    std::optional<std::string> key = {};
  };

  bool isKeyNext() const { return !m_open.empty() && m_open.back().value->is_object() && !m_open.back().key; }

  static Json meaningOf(const std::string& word) {
    if (word == "true" || word == "false") return word == "true";
    if (word == "null" || word == "~") return nullptr;
    double number = 0.0;
    ErrorCode why{};
    return parseDecimal(word, number, why) ? Json(number) : Json(word);
  }

  void count(const YAML::Mark& mark) {
    if (++m_nodes > YamlLimits::kMostNodes) throw RefusedYaml(mark, "it has too many values");
  }

  // A container's element is never moved while it is open: only the innermost one grows.
  Json* add(const YAML::Mark& mark, Json value) {
    count(mark);
    if (m_open.empty()) return &m_value.emplace(std::move(value));
    Open& within = m_open.back();
    if (within.value->is_array()) return &within.value->emplace_back(std::move(value));
    if (!within.key) throw RefusedYaml(mark, "a key of a map is not a text");
    const auto [at, isNew] = within.value->emplace(std::move(*within.key), std::move(value));
    within.key.reset();
    if (!isNew) throw RefusedYaml(mark, "a key of a map is there twice");
    return &*at;
  }

  void open(const YAML::Mark& mark, Json value) {
    if (m_open.size() >= YamlLimits::kDeepest) throw RefusedYaml(mark, "it is nested too deeply");
    m_open.push_back({add(mark, std::move(value))});
  }

  std::optional<Json> m_value;
  std::vector<Open> m_open;
  std::size_t m_nodes = 0;
};

}  // namespace

Result<Json> parseYaml(std::string_view text, std::string_view element) {
  const auto refused = [&](std::string what, int line) {
    Error error{ErrorCode::ElementMalformed, {std::string(element), std::move(what)}, {}, {}};
    if (line >= 0) error.position = InputPosition::line(static_cast<std::uint64_t>(line) + 1);
    return error;
  };
  if (text.size() > YamlLimits::kMostBytes) return refused("it is too large", -1);
  JsonOfYaml made;
  try {
    std::istringstream in{std::string(text)};
    YAML::Parser parser(in);
    while (parser.HandleNextDocument(made)) {
    }
  } catch (const RefusedYaml& why) {
    return refused(why.msg, why.mark.line);
  } catch (const YAML::ParserException& why) {
    return refused("it is not YAML", why.mark.line);
  } catch (const YAML::Exception&) {
    return refused("it is not YAML", -1);
  }
  return made.takeValue();
}

}  // namespace handwheel
