// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/FinishReport.h"

#include "base/NumberText.h"
#include "machining/finish/FinishReading.h"
#include "machining/measure/RoughnessGrade.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

nlohmann::json finiteOrNull(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

std::string stretchText(const FinishInterval& stretch, const std::string& grade) {
  const double ra = stretch.reading.roughness;
  return "Ra " + (std::isfinite(ra) ? roundedText(ra, 3) + " µm" : std::string("not known")) +
         (grade.empty() ? "" : " (" + grade + ")") + ", Z " + shownText(stretch.from) + " to " + shownText(stretch.to);
}

nlohmann::json stretchJson(const TurnedPart& part, const FinishInterval& stretch) {
  const std::string grade = roughnessGrade(stretch.reading.roughness);
  nlohmann::json json = {{"from", stretch.from},
                         {"to", stretch.to},
                         {"roughness_um", finiteOrNull(stretch.reading.roughness)},
                         {"largest_um", finiteOrNull(stretch.reading.largest)},
                         {"grade", nullptr},
                         {"pass", std::uint64_t{stretch.pass} + 1},
                         {"tool", nullptr},
                         {"kind", nullptr},
                         {"nose_radius", nullptr},
                         {"feed", finiteOrNull(stretch.feed)},
                         {"text", stretchText(stretch, grade)}};
  if (!grade.empty()) json["grade"] = grade;
  if (stretch.pass >= part.passes.size()) return json;
  const TurningPass& pass = *part.passes[stretch.pass];
  json["nose_radius"] = pass.tool ? pass.tool->noseRadius : pass.noseRadius;
  if (pass.tool) json["tool"] = pass.tool->id, json["kind"] = idOf(pass.tool->kind);
  return json;
}

nlohmann::json sideJson(const TurnedPart& part, TurningSide side) {
  nlohmann::json all = nlohmann::json::array();
  for (const FinishInterval& stretch : finishIntervals(part.finish, part.profile, side)) {
    if (all.size() == kMostStretches) break;
    all.push_back(stretchJson(part, stretch));
  }
  return all;
}

}  // namespace

nlohmann::json finishJson(const TurnedPart& part) {
  return {{"outside", sideJson(part, TurningSide::Outside)}, {"bore", sideJson(part, TurningSide::Bore)}};
}

}  // namespace handwheel
