// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/TargetReport.h"

#include "base/NumberText.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

std::string reportedSizeText(double value) {
  return roundedText(std::round(value * 1e4) / 1e4, 9);
}

nlohmann::json pointJson(const TargetDeviation::Extreme& point) {
  return {{"distance", point.distance}, {"r", point.at.x()}, {"z", point.at.y()}};
}

}  // namespace

TargetDeviation deviationOf(const WorkpieceSnapshot& workpiece, Progress progress) {
  constexpr double kBarSteps = 1000.0;
  const StockCylinder& stock = workpiece.stock;
  const TargetProfile& target = workpiece.target->profile;
  const auto from = [&](const TurnedProfile& part) {
    return deviationFrom(target, part, stock.position, progress, rangeOfTarget(target, part, stock.position));
  };
  return from(workpiece.part ? workpiece.part->profile : TurnedProfile(stock, stock.length / kBarSteps));
}

std::string textOf(const ProfileFeature& f) {
  std::string text = (f.isInner ? "inner " : "") + std::string(nameOf(f.kind));
  if (f.kind == ProfileFeature::Kind::Cylinder) text += " Ø" + reportedSizeText(f.value);
  if (f.kind == ProfileFeature::Kind::Arc) text += " R" + reportedSizeText(f.value);
  if (f.kind == ProfileFeature::Kind::Taper)
    text += " " + reportedSizeText(f.value * 180.0 / M_PI) + "° to the axis, Ø" + reportedSizeText(2.0 * f.low.x()) +
            " to Ø" + reportedSizeText(2.0 * f.high.x());
  if (f.kind == ProfileFeature::Kind::Curve)
    text += " Ø" + reportedSizeText(2.0 * f.low.x()) + " to Ø" + reportedSizeText(2.0 * f.high.x());
  if (f.kind == ProfileFeature::Kind::FlatFace)
    return text + " Ø" + reportedSizeText(2.0 * f.low.x()) + " to Ø" + reportedSizeText(2.0 * f.high.x()) + ", Z " +
           reportedSizeText(f.low.y());
  return text + ", Z " + reportedSizeText(f.low.y()) + " to " + reportedSizeText(f.high.y()) + ", length " +
         reportedSizeText(f.length());
}

nlohmann::json dimensionsJson(const TargetProfile& section, double tolerance) {
  nlohmann::json all = nlohmann::json::array();
  for (const ProfileFeature& f : withCurves(featuresOf(section, tolerance))) {
    nlohmann::json one = {{"kind", nameOf(f.kind)}, {"inner", f.isInner}, {"z_from", f.low.y()}, {"z_to", f.high.y()},
                          {"r_from", f.low.x()},    {"r_to", f.high.x()}, {"text", textOf(f)}};
    if (f.kind == ProfileFeature::Kind::Cylinder) one["diameter"] = f.value;
    if (f.kind == ProfileFeature::Kind::Arc) one["radius"] = f.value;
    if (f.kind == ProfileFeature::Kind::Taper) one["angle"] = f.value;
    all.push_back(std::move(one));
  }
  return all;
}

nlohmann::json deviationJson(const TargetDeviation& deviation) {
  return {{"largest_over", pointJson(deviation.largestOver)},
          {"largest_under", pointJson(deviation.largestUnder)},
          {"largest", deviation.largest()}};
}

}  // namespace handwheel
