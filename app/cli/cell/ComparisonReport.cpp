// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/ComparisonReport.h"

#include "base/NumberText.h"
#include "cli/Messages.h"
#include "cli/cell/PathReport.h"

namespace handwheel {

namespace {

constexpr std::size_t kWidth = 12;  // Width of a column

std::string padded(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : " " + text;
}

}  // namespace

nlohmann::ordered_json toJson(const CellScene& scene, std::span<const ComparedPath> paths,
                              std::span<const std::string> names) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const ComparedPath& each : paths) {
    nlohmann::ordered_json row = {
        {"critical", names.first(each.critical)}, {"optimised", each.isOptimised}, {"solved", bool(each.checked)}};
    if (each.checked) {
      row.update(toJson(scene, each.planned->path, *each.checked));
      row["seconds"] = each.planned->seconds;
      row["checks"] = each.planned->steps;
    } else {
      row["reason"] = sentenceFor(each.planned ? each.checked.error() : each.planned.error());
    }
    rows.push_back(std::move(row));
  }
  return {{"comparison", rows}};
}

std::string comparisonText(std::span<const ComparedPath> paths, std::span<const std::string> names) {
  std::size_t first = 24;
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  first = std::max(first, all.size() + 6);
  std::string text = "critical configurations" + std::string(first - 23, ' ');
  for (const char* column : {"optimised", "length/rad", "cycle/s", "planned/s", "manipul.", "security/mm", "places"})
    text += padded(column, kWidth);
  text += "\n";
  for (const ComparedPath& each : paths) {
    std::string some;
    for (const std::string& name : names.first(each.critical)) some += (some.empty() ? "" : ", ") + name;
    if (some.empty()) some = "none";
    text += some + std::string(first - some.size(), ' ') + padded(each.isOptimised ? "yes" : "no", kWidth);
    if (!each.checked) {
      text += "  " + sentenceFor(each.planned ? each.checked.error() : each.planned.error()) + "\n";
      continue;
    }
    const PathMetrics& metrics = each.checked->metrics;
    for (const double value :
         {metrics.length, each.checked->seconds, each.planned->seconds, metrics.manipulability, metrics.security})
      text += padded(roundedText(value, 4), kWidth);
    text += padded(std::to_string(each.planned->path.waypoints.size()), kWidth) +
            (each.checked->isCertified() ? "" : "  not proven free") + "\n";
  }
  return text;
}

}  // namespace handwheel
