// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheCrashJson.h"

#include "base/JsonText.h"
#include "machining/lathe/LatheRun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

constexpr std::array<const char*, kLatheParts> kPartIds = {"edge",      "holder", "tool-post", "slide", "fitting",
                                                           "tailstock", "jaws",   "chuck",     "work"};
constexpr std::array<const char*, 6> kCauseIds = {"contact",  "rapid",    "spindle-at-rest",
                                                  "reversed", "too-deep", "overload"};

// The value with this id, in the order of the enumeration.
template <class Value, std::size_t N>
std::optional<Value> valueNamed(const std::array<const char*, N>& ids, const std::string& id) {
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) return std::nullopt;
  return static_cast<Value>(found - ids.begin());
}

double finiteAt(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  const double value = found != object.end() && found->is_number() ? found->get<double>() : 0.0;
  return std::isfinite(value) ? value : 0.0;
}

}  // namespace

nlohmann::json crashesToJson(const std::vector<LatheCollision>& crashes) {
  nlohmann::json all = nlohmann::json::array();
  for (const LatheCollision& crash : crashes) {
    all.push_back({{"moving", kPartIds[static_cast<std::size_t>(crash.moving)]},
                   {"struck", kPartIds[static_cast<std::size_t>(crash.struck)]},
                   {"cause", kCauseIds[static_cast<std::size_t>(crash.cause)]},
                   {"r", crash.place.x()},
                   {"z", crash.place.y()},
                   {"depth", crash.depth},
                   {"time", crash.time},
                   {"tool", crash.tool}});
  }
  return all;
}

std::vector<LatheCollision> crashesFrom(const nlohmann::json& json) {
  constexpr std::size_t kLongestId = 100;
  std::vector<LatheCollision> crashes;
  if (!json.is_array()) return crashes;
  for (const nlohmann::json& each : json) {
    if (crashes.size() == LatheRun::kMostCollisions) break;
    if (!each.is_object()) continue;
    const auto moving = valueNamed<LathePart>(kPartIds, stringAt(each, "moving"));
    const auto struck = valueNamed<LathePart>(kPartIds, stringAt(each, "struck"));
    const auto cause = valueNamed<CrashCause>(kCauseIds, stringAt(each, "cause"));
    const std::string tool = stringAt(each, "tool");
    if (!moving || !struck || !cause || tool.size() > kLongestId) continue;
    crashes.push_back({*moving,
                       *struck,
                       *cause,
                       {finiteAt(each, "r"), finiteAt(each, "z")},
                       finiteAt(each, "depth"),
                       finiteAt(each, "time"),
                       tool});
  }
  return crashes;
}

}  // namespace handwheel
