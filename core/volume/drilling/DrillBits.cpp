// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillBits.h"

#include "base/JsonText.h"
#include "base/NumberText.h"
#include "volume/drilling/DrillResources.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace handwheel {
namespace {

constexpr const char* kTable = "the table of drills";
constexpr std::array<std::pair<std::string_view, DrillShape>, 4> kShapes{
    {{"ball", DrillShape::Ball}, {"burr", DrillShape::Burr}, {"twist", DrillShape::Twist}, {"saw", DrillShape::Saw}}};

bool isWithin(double x, double least, double most) {
  return x >= least && x <= most;
}

bool isDiameter(double x) {
  return isWithin(x, DrillBit::kLeastDiameter, DrillBit::kLargestDiameter);
}

bool isWidth(double x, double diameter) {
  return isWithin(x, DrillBit::kLeastWidth, diameter);
}

// Empty: valid.
std::string problemOf(const DrillBitType& type, const std::vector<DrillBitType>& before) {
  const DrillBit& tool = type.tool;
  const bool isKnown =
      std::any_of(before.begin(), before.end(), [&](const auto& other) { return other.id == type.id; });
  if (type.id.empty() || type.id.find(':') != std::string::npos) return "an id is empty or has a colon";
  if (isKnown) return type.id + ": there are two of it";
  if (!isDiameter(tool.diameter)) return type.id + ": its diameter is not from 0.05 to 200 mm";
  if (tool.shape == DrillShape::Twist && !isWithin(tool.pointAngle, M_PI / 18.0, M_PI))
    return type.id + ": its point_angle is not from 10 to 180 degrees";
  if (tool.shape == DrillShape::Twist && !isWithin(tool.length, tool.diameter, 20.0 * tool.diameter))
    return type.id + ": its length is not from 1 to 20 diameters";
  if (tool.shape == DrillShape::Saw && !isWidth(tool.width, tool.diameter))
    return type.id + ": its width is not from 0.01 mm to its diameter";
  return {};
}

DrillBitType typeIn(const nlohmann::json& row) {
  DrillBitType type{row.at("id"), {}};
  const std::string word = row.at("shape");
  const auto* const shape =
      std::find_if(kShapes.begin(), kShapes.end(), [&](const auto& s) { return s.first == word; });
  if (shape == kShapes.end()) throw nlohmann::json::other_error::create(501, "no shape is called " + word, nullptr);
  type.tool.shape = shape->second;
  type.tool.diameter = row.at("diameter");
  type.tool.length = 10.0 * type.tool.diameter;
  if (type.tool.shape == DrillShape::Twist) {
    type.tool.pointAngle = row.at("point_angle").get<double>() * M_PI / 180.0;
    type.tool.length = row.at("length");
  }
  if (type.tool.shape == DrillShape::Saw) type.tool.width = row.at("width");
  return type;
}

}  // namespace

Result<std::vector<DrillBitType>> drillBitsFromJson(std::string_view text) {
  const Result<nlohmann::json> json = parseJson(text, kTable);
  if (!json) return json.error();
  const auto fail = [](const std::string& why) { return Error{ErrorCode::ElementMalformed, {kTable, why}, {}, {}}; };
  std::vector<DrillBitType> all;
  try {
    const nlohmann::json& rows = json->at("tools");
    if (!rows.is_array() || rows.empty() || rows.size() > DrillBitType::kMost)
      return fail("there are none, or more than " + std::to_string(DrillBitType::kMost));
    for (const nlohmann::json& row : rows) {
      DrillBitType type = typeIn(row);
      if (const std::string problem = problemOf(type, all); !problem.empty()) return fail(problem);
      all.push_back(std::move(type));
    }
  } catch (const nlohmann::json::exception& problem) {
    return fail(problem.what());
  }
  return all;
}

const std::vector<DrillBitType>& drillBits() {
  static const Result<std::vector<DrillBitType>> kShipped = drillBitsFromJson(drillBitsResource());
  assert(kShipped);
  return *kShipped;
}

std::optional<DrillBit> drillBitOf(std::string_view word) {
  std::array<std::string_view, 3> parts;
  std::size_t count = 0;
  for (bool isLast = false; !isLast; ++count) {
    if (count == parts.size()) return std::nullopt;
    const std::size_t colon = word.find(':');
    isLast = colon == std::string_view::npos;
    parts[count] = word.substr(0, colon);
    if (!isLast) word.remove_prefix(colon + 1);
  }
  const std::vector<DrillBitType>& all = drillBits();
  const auto type = std::find_if(all.begin(), all.end(), [&](const auto& t) { return t.id == parts[0]; });
  double diameter = 0.0;
  ErrorCode why{};
  if (type == all.end() || count < 2 || !parseDecimal(parts[1], diameter, why) || !isDiameter(diameter))
    return std::nullopt;
  DrillBit tool = type->tool;
  tool.length *= diameter / tool.diameter;
  tool.diameter = diameter;
  if (tool.shape != DrillShape::Saw) return count == 2 ? std::optional(tool) : std::nullopt;
  if (count == 3 && !parseDecimal(parts[2], tool.width, why)) return std::nullopt;
  return isWidth(tool.width, diameter) ? std::optional(tool) : std::nullopt;
}

std::string wordOf(const DrillBit& bit) {
  const std::string word =
      std::string(kShapes[static_cast<std::size_t>(bit.shape)].first) + ":" + shortestText(bit.diameter);
  return bit.shape == DrillShape::Saw ? word + ":" + shortestText(bit.width) : word;
}

}  // namespace handwheel
