// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramToolsJson.h"

#include "base/JsonText.h"
#include "machining/TurningPass.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::json;

constexpr const char *kNumber = "number", *kBody = "tool", *kNose = "nose_radius", *kOrientation = "orientation",
                     *kOffset = "offset", *kUpsideDown = "upside_down";
constexpr const char *kPost = "post", *kInsert = "insert", *kFront = "front", *kBehind = "behind", *kToolUp = "up",
                     *kDown = "down";
constexpr std::size_t kMostStored = 1000;
constexpr int kMostNumber = 99'999;
constexpr double kMostOffset = 1e4;  // mm

// Returns nothing if the tool is impossible.
std::optional<std::pair<int, ProgramTool>> toolFrom(const Json& json, const LatheTools& bodies) {
  const auto whole = [&](const char* key, int largest) -> std::optional<int> {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number_integer()) return std::nullopt;
    const auto value = found->get<std::int64_t>();
    return value >= 0 && value <= largest ? std::optional(static_cast<int>(value)) : std::nullopt;
  };
  if (!json.is_object()) return std::nullopt;
  ProgramTool tool;
  const std::optional<int> number = whole(kNumber, kMostNumber), orientation = whole(kOrientation, 9);
  if (!number || !orientation) return std::nullopt;
  tool.orientation = *orientation;
  if (const std::string body = stringAt(json, kBody); !body.empty()) {
    tool.body = toolNamed(bodies, body);
    if (!tool.body) return std::nullopt;
  }
  const auto nose = json.find(kNose), offset = json.find(kOffset);
  if (nose == json.end() || !nose->is_number() || offset == json.end()) return std::nullopt;
  if (!offset->is_array() || offset->size() != 2 || !(*offset)[0].is_number() || !(*offset)[1].is_number())
    return std::nullopt;
  tool.noseRadius = nose->get<double>();
  tool.offset = {(*offset)[0].get<double>(), (*offset)[1].get<double>()};
  tool.isTurnedOver = json.value(kUpsideDown, Json(false)) == Json(true);
  const bool isPossible = tool.noseRadius >= 0.0 && tool.noseRadius <= TurningPass::kLargestNose &&
                          std::abs(tool.offset.x()) <= kMostOffset && std::abs(tool.offset.y()) <= kMostOffset;
  return isPossible ? std::optional(std::pair(*number, tool)) : std::nullopt;
}

}  // namespace

Json toJson(const ProgramTools& tools) {
  Json all = Json::array();
  for (const auto& [number, tool] : tools) {
    Json json = {{kNumber, number},
                 {kNose, tool.noseRadius},
                 {kOrientation, tool.orientation},
                 {kOffset, {tool.offset.x(), tool.offset.y()}}};
    if (tool.body) json[kBody] = tool.body->id;
    if (tool.isTurnedOver) json[kUpsideDown] = true;
    all.push_back(std::move(json));
  }
  return all;
}

ProgramTools programToolsFrom(const Json& json, const LatheTools& bodies, std::vector<Error>& damage) {
  ProgramTools tools;
  if (!json.is_array()) return tools;
  for (const Json& each : json) {
    auto tool = toolFrom(each, bodies);
    if (tool && tools.size() < kMostStored) {
      tools.insert_or_assign(tool->first, std::move(tool->second));
    } else {
      damage.push_back({ErrorCode::ElementMalformed, {"program_tools", "a tool is impossible or not known"}, {}, {}});
    }
    if (damage.size() > kMostStored) break;
  }
  return tools;
}

Json toJson(const ProgramPost& post) {
  return {{kPost, post.isInFront ? kFront : kBehind}, {kInsert, post.isInsertUp ? kToolUp : kDown}};
}

ProgramPost programPostFrom(const Json& json, std::vector<Error>& damage) {
  if (json.is_null()) return {};
  const std::string post = stringAt(json, kPost), insert = stringAt(json, kInsert);
  if ((post == kFront || post == kBehind) && (insert == kToolUp || insert == kDown))
    return {post == kFront, insert == kToolUp};
  damage.push_back({ErrorCode::ElementMalformed, {"program_post", "its sides are not known"}, {}, {}});
  return {};
}

}  // namespace handwheel
