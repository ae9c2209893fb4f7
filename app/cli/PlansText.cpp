// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/PlansText.h"

#include "base/NumberText.h"
#include "base/ShownDistance.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

nlohmann::json listAt(const nlohmann::json& described, const char* key) {
  return described.value(key, nlohmann::json::array());
}

std::string namesIn(const nlohmann::json& list) {
  std::string text;
  for (const nlohmann::json& name : list) text += (text.empty() ? "" : ", ") + name.get<std::string>();
  return text;
}

// Returns the reasons why a planned path does not match the cell any more.
std::string outdatedText(const nlohmann::json& path) {
  std::string text;
  const auto add = [&](const std::string& reason) { text += (text.empty() ? ", outdated: " : "; ") + reason; };
  if (path.contains("part_moved")) add(path["part_moved"].get<std::string>() + " has moved");
  if (path.contains("base_moved")) add("its robot has moved");
  if (path.contains("tool_changed")) add("the tool centre point was changed");
  if (path.contains("targets_moved")) add("it misses " + namesIn(path["targets_moved"]));
  if (path.contains("frames_moved")) add(namesIn(path["frames_moved"]) + " has moved");
  if (path.contains("configurations_changed")) add(namesIn(path["configurations_changed"]) + " was changed");
  return text;
}

// Returns the text for a change since a path was verified, by its key in the description.
std::string changeText(const std::string& changed) {
  static const std::map<std::string, std::string> kTexts{
      {"robots", "a robot was moved, added or removed"},
      {"path", "the path was changed"},
      {"joints", "other joints were moved"},
      {"bodies", "the bodies were changed"},
      {"allowed", "the allowed pairs, or the shapes left out, were changed"},
      {"tool", "the tool centre point was changed"},
      {"clearance", "the clearance was changed"},
      {"targets", "its targets or frames were moved"},
      {"configurations", "its configurations were changed"},
      {"rates", "what is assumed for the times was changed"}};
  return kTexts.at(changed);
}

// Returns the reason why a path that collides nowhere is not proven free; empty if there is none.
std::string unprovenText(const nlohmann::json& found) {
  for (const nlohmann::json& each : listAt(found, "missing_shapes")) {
    if (each["state"] == "missing")
      return "not proven: the shape of " + each["part"].get<std::string>() + " could not be read";
  }
  const auto gap = found.find("not_proven");
  if (gap == found.end()) return {};
  const std::string waypoint = "place " + std::to_string((*gap)["place"].get<std::size_t>() + 1);
  if ((*gap)["reason"] == "cnt") return "not proven: CNT rounds the corner at " + waypoint;
  return "proven only up to " + waypoint + ": '" + (*gap)["text"].get<std::string>() + "' may grip or release";
}

// Returns the stored result of the verification of a path, with a note if the cell has changed since then.
std::string verifiedText(const nlohmann::json& path) {
  if (!path.contains("verified")) return {};
  const nlohmann::json& found = path["verified"];
  const auto count = [&](const char* key) { return found[key].get<std::size_t>(); };
  const nlohmann::json& changed = found["changed_since"];
  std::string text = changed.is_null() ? ", verified " + found["at"].get<std::string>() + ": "
                                       : ", not verified since " + changeText(changed.get<std::string>()) +
                                             "; before, " + found["at"].get<std::string>() + ": ";
  if (found["certified"].get<bool>()) {
    text += "free of collisions, clearance " + shownText(shownDistance(found["clearance_mm"].get<double>())) + " mm";
    if (found.value("touching", false)) text += ", touching";
    for (const nlohmann::json& each : listAt(found, "missing_shapes"))
      text += ", " + each["state"].get<std::string>() + ": " + each["part"].get<std::string>();
    constexpr std::size_t kMostPairs = 5;
    const nlohmann::json pairs = listAt(found, "not_checked");
    for (std::size_t i = 0; i < std::min(pairs.size(), kMostPairs); ++i)
      text += ", not checked: " + pairs[i][0].get<std::string>() + " with " + pairs[i][1].get<std::string>();
    return pairs.size() > kMostPairs ? text + " and " + std::to_string(pairs.size() - kMostPairs) + " more pairs"
                                     : text;
  }
  if (found.contains("stops_at")) return text + "a line to place " + std::to_string(count("stops_at") + 1) + " ends";
  if (const std::string gap = unprovenText(found); !gap.empty() && count("collisions") + count("too_near") == 0)
    return text + gap;
  text += std::to_string(count("collisions")) + " times it collides";
  return count("too_near") > 0 ? text + ", " + std::to_string(count("too_near")) + " times it is too near" : text;
}

}  // namespace

std::string plansText(const nlohmann::json& described, const std::string& before) {
  if (!described.contains("may_touch")) return {};
  constexpr std::size_t kMostPairs = 50;
  std::string text;
  const auto add = [&](const std::string& line) { text += before + line + "\n"; };
  for (const auto& [key, word] : {std::pair("configurations", "configuration "), std::pair("targets", "target "),
                                  std::pair("frames", "frame ")}) {
    for (const nlohmann::json& each : listAt(described, key)) add(word + each["name"].get<std::string>());
  }
  for (const nlohmann::json& path : listAt(described, "paths")) {
    add("path " + path["name"].get<std::string>() + ", " + std::to_string(path["places"].get<std::size_t>()) +
        " places" + outdatedText(path) + verifiedText(path));
  }
  const nlohmann::json pairs = listAt(described, "may_touch");
  for (std::size_t i = 0; i < std::min(pairs.size(), kMostPairs); ++i)
    add("may touch: " + pairs[i][0].get<std::string>() + " with " + pairs[i][1].get<std::string>());
  if (pairs.size() > kMostPairs) add("may touch: " + std::to_string(pairs.size() - kMostPairs) + " more pairs");
  return text;
}

}  // namespace handwheel
