// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/exercise/DescribedHoles.h"

#include "base/JsonText.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

constexpr double kCycles = 250.0;        // Hz
constexpr double kLongestHole = 600.0;   // s, of a hole
constexpr double kFarthestTip = 1000.0;  // mm, from the entry
constexpr std::size_t kMostPathPoints = 10'000, kMostDescribed = 100;

struct PathPoint {
  double time;
  Vec3 position;  // position of the tip
};

std::optional<std::vector<PathPoint>> pointsIn(const nlohmann::json& hole, const DrillPlan& plan) {
  const auto rows = hole.is_object() ? hole.find("points") : hole.end();
  if (!hole.is_object() || rows == hole.end() || !rows->is_array() || rows->size() > kMostPathPoints)
    return std::nullopt;
  const Vec3 beside = plan.direction.unitOrthogonal(), across = plan.direction.cross(beside);
  std::vector<PathPoint> points;
  for (const nlohmann::json& row : *rows) {
    std::vector<double> numbers = numbersAt({{"row", row}}, "row", 5);
    if (numbers.size() < 2 || numbers.size() > 4) return std::nullopt;
    numbers.resize(4);
    const bool isPosition =
        std::all_of(numbers.begin() + 1, numbers.end(), [](double x) { return std::abs(x) < kFarthestTip; });
    const double before = points.empty() ? 0.0 : points.back().time;
    if (!isPosition || !(numbers[0] >= before && numbers[0] <= kLongestHole)) return std::nullopt;
    points.push_back(
        {numbers[0], plan.entry + numbers[1] * plan.direction + numbers[2] * beside + numbers[3] * across});
  }
  return points;
}

std::shared_ptr<const DrillRecord> recordOf(const std::vector<PathPoint>& points, const DrillingTask& task) {
  auto record = std::make_shared<DrillRecord>();
  record->setup = task.setup();
  const Vec3 axis = -task.plan.direction, toCentre = task.tool.reach() * axis;
  std::size_t next = 0;
  for (double i = 0.0; !points.empty() && i <= std::ceil(points.back().time * kCycles); ++i) {
    const double time = i / kCycles;
    while (next + 1 < points.size() && points[next].time < time) ++next;
    const PathPoint &to = points[next], &from = points[next == 0 ? 0 : next - 1];
    const double span = to.time - from.time, share = span > 0.0 ? (time - from.time) / span : 1.0;
    const Vec3 tip = from.position + std::clamp(share, 0.0, 1.0) * (to.position - from.position);
    record->poses.push_back(DrillPose::of(tip + toCentre, axis, time));
  }
  return record;
}

}  // namespace

Result<DrilledHoles> describedHoles(const nlohmann::json& description, const DrillingTask& task) {
  const auto malformed = [](const char* what) { return Error{ErrorCode::ElementMalformed, {"holes", what}, {}, {}}; };
  const auto list = description.is_object() ? description.find("holes") : description.end();
  if (!description.is_object() || list == description.end() || !list->is_array() || list->size() > kMostDescribed)
    return malformed("a list of holes was expected");
  DrilledHoles holes;
  for (const nlohmann::json& each : *list) {
    const auto points = pointsIn(each, task.plan);
    if (!points) return malformed("points were expected: time, depth, beside, across, in order of time");
    holes.push_back(recordOf(*points, task));
  }
  return holes;
}

}  // namespace handwheel
