// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/TargetJson.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::json;
using Segments = std::vector<ProfileSegment>;

constexpr const char *kSegments = "segments", *kOuter = "outer", *kInner = "inner";

Error malformedTarget(const char* what) {
  return {ErrorCode::ElementMalformed, {"target", what}, {}, {}};
}

// The rows of so many numbers under a key; none where something else is there.
template <std::size_t Count>
std::optional<std::vector<std::array<double, Count>>> rowsIn(const Json& object, const char* key) {
  std::vector<std::array<double, Count>> rows;
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return rows;
  if (!found->is_array() || found->size() > TargetProfile::kMostSegments) return std::nullopt;
  for (const Json& each : *found) {
    if (!each.is_array() || each.size() != Count) return std::nullopt;
    if (!std::all_of(each.begin(), each.end(), [](const Json& n) { return n.is_number(); })) return std::nullopt;
    rows.push_back(each.template get<std::array<double, Count>>());
  }
  return rows;
}

// Goes around with the material on the left: down the bore, before the outside if it is open below, else after it.
Result<TargetProfile> fromSides(const std::vector<std::array<double, 2>>& outer,
                                const std::vector<std::array<double, 2>>& inner) {
  if (outer.size() < 2 || inner.size() == 1) return malformedTarget("it has too few points");
  std::vector<ProfilePoint> points;
  const auto takeOuter = [&] {
    std::for_each(outer.begin(), outer.end(), [&](const auto& p) { points.emplace_back(p[0], p[1]); });
  };
  const auto takeInner = [&] {
    std::for_each(inner.rbegin(), inner.rend(), [&](const auto& p) { points.emplace_back(p[0], p[1]); });
  };
  for (const auto* line : {&outer, &inner}) {
    const auto isBack = [](const auto& a, const auto& b) { return b[1] < a[1]; };
    if (std::adjacent_find(line->begin(), line->end(), isBack) != line->end())
      return malformedTarget("the z of the points is not ascending");
  }
  const bool isOpenBelow = !inner.empty() && inner.front()[1] == outer.front()[1];
  const bool isOpenAbove = !inner.empty() && inner.back()[1] == outer.back()[1];
  if (!inner.empty() && !isOpenBelow && !isOpenAbove)
    return malformedTarget("the bore is not open at an end of the part");
  if (isOpenBelow && !isOpenAbove) takeInner();
  takeOuter();
  if (isOpenAbove) takeInner();
  if (isOpenBelow && isOpenAbove) points.push_back(points.front());
  Segments segments;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (points[i] != points[i + 1]) segments.push_back({points[i], points[i + 1], 0.0});
  }
  return TargetProfile::make(std::move(segments));
}

Result<TargetProfile> targetOf(const Json& json) {
  if (!json.is_object()) return malformedTarget("an object was expected");
  const auto outer = rowsIn<2>(json, kOuter), inner = rowsIn<2>(json, kInner);
  const auto rows = rowsIn<5>(json, kSegments);
  if (!outer || !inner) return malformedTarget("points of two numbers each were expected");
  if (!rows) return malformedTarget("segments of five numbers each were expected");
  if (rows->empty()) return fromSides(*outer, *inner);
  Segments segments;
  for (const auto& [r, z, toR, toZ, bulge] : *rows) segments.push_back({{r, z}, {toR, toZ}, bulge});
  return TargetProfile::make(std::move(segments));
}

}  // namespace

Json toJson(const TargetProfile& target) {
  Json rows = Json::array();
  for (const ProfileSegment& s : target.segments())
    rows.push_back({s.from.x(), s.from.y(), s.to.x(), s.to.y(), s.bulge});
  return {{kSegments, std::move(rows)}};
}

std::optional<TargetProfile> targetFrom(const Json& json, std::vector<Error>& damage) {
  if (json.is_null()) return std::nullopt;
  Result<TargetProfile> target = targetOf(json);
  if (target) return std::move(target).value();
  damage.push_back(target.error());
  return std::nullopt;
}

}  // namespace handwheel
