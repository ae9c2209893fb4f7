// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheCrashJson.h"

#include "base/JsonFields.h"
#include "base/JsonText.h"
#include "machining/lathe/LatheRun.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::array<const char*, kLatheParts> kPartIds = {"edge",      "holder", "tool-post", "slide", "fitting",
                                                           "tailstock", "jaws",   "chuck",     "work"};
constexpr std::array<const char*, 6> kCauseIds = {"contact",  "rapid",    "spindle-at-rest",
                                                  "reversed", "too-deep", "overload"};

// Returns the value with this id, in the order of the enumeration.
template <class Value, std::size_t N>
std::optional<Value> valueNamed(const std::array<const char*, N>& ids, const std::string& id) {
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) return std::nullopt;
  return static_cast<Value>(found - ids.begin());
}

// Visits the keys of the numbers and texts; enumerations are read and written separately.
template <class Crash>
void visitCrash(Crash& crash, const auto& visit) {
  visit("r", crash.position.x());
  visit("z", crash.position.y());
  visit("depth", crash.depth);
  visit("time", crash.time);
  visit("tool", crash.tool);
  visit("passes", crash.passes);
}
constexpr const char *kMoving = "moving", *kStruck = "struck", *kCause = "cause";

}  // namespace

nlohmann::json crashesToJson(const std::vector<LatheCollision>& crashes) {
  nlohmann::json all = nlohmann::json::array();
  for (const LatheCollision& crash : crashes) {
    nlohmann::json& one = all.emplace_back(nlohmann::json::object());
    one[kMoving] = kPartIds[static_cast<std::size_t>(crash.moving)];
    one[kStruck] = kPartIds[static_cast<std::size_t>(crash.struck)];
    one[kCause] = kCauseIds[static_cast<std::size_t>(crash.cause)];
    visitCrash(crash, JsonFieldWriter(one));
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
    const auto moving = valueNamed<LathePart>(kPartIds, stringAt(each, kMoving));
    const auto struck = valueNamed<LathePart>(kPartIds, stringAt(each, kStruck));
    const auto cause = valueNamed<CrashCause>(kCauseIds, stringAt(each, kCause));
    LatheCollision crash;
    visitCrash(crash, JsonFieldReader(each));
    const bool isFinite = crash.position.allFinite() && std::isfinite(crash.depth) && std::isfinite(crash.time) &&
                          std::isfinite(crash.passes);
    if (!moving || !struck || !cause || !isFinite || crash.tool.size() > kLongestId) continue;
    crash.moving = *moving;
    crash.struck = *struck;
    crash.cause = *cause;
    crashes.push_back(std::move(crash));
  }
  return crashes;
}

}  // namespace handwheel
