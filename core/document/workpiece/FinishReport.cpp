// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/FinishReport.h"

#include "base/NumberText.h"
#include "machining/finish/FaceFinish.h"
#include "machining/finish/FinishReading.h"
#include "machining/measure/RoughnessGrade.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

nlohmann::json finiteOrNull(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

std::string roughnessText(double ra, const std::string& grade) {
  return "Ra " + (std::isfinite(ra) ? roundedText(ra, 3) + " µm" : std::string("not known")) +
         (grade.empty() ? "" : " (" + grade + ")");
}

// Returns what a surface of this roughness and the pass that made it have in common.
nlohmann::json surfaceJson(const TurnedPart& part, double roughness, std::uint32_t number, double feed) {
  const std::string grade = roughnessGrade(roughness);
  nlohmann::json json = {{"roughness_um", finiteOrNull(roughness)},
                         {"grade", nullptr},
                         {"pass", std::uint64_t{number} + 1},
                         {"tool", nullptr},
                         {"kind", nullptr},
                         {"nose_radius", nullptr},
                         {"feed", finiteOrNull(feed)}};
  if (!grade.empty()) json["grade"] = grade;
  if (number >= part.passes.size()) return json;
  const TurningPass& pass = *part.passes[number];
  json["nose_radius"] = pass.tool ? pass.tool->noseRadius : pass.noseRadius;
  if (pass.tool) json["tool"] = pass.tool->id, json["kind"] = idOf(pass.tool->kind);
  return json;
}

nlohmann::json stretchJson(const TurnedPart& part, const FinishInterval& stretch, double position) {
  const double ra = stretch.reading.roughness;
  nlohmann::json json = surfaceJson(part, ra, stretch.pass, stretch.feed);
  json["from"] = stretch.from + position;
  json["to"] = stretch.to + position;
  json["largest_um"] = finiteOrNull(stretch.reading.largest);
  json["text"] = roughnessText(ra, roughnessGrade(ra)) + ", Z " + shownText(stretch.from + position) + " to " +
                 shownText(stretch.to + position);
  return json;
}

nlohmann::json facesJson(const TurnedPart& part, double position) {
  nlohmann::json all = nlohmann::json::array();
  for (const FaceFinish& face : faceFinish(part.section(), part.passes)) {
    if (all.size() == kMostStretches) break;
    nlohmann::json json = surfaceJson(part, face.roughness, face.pass, face.feed);
    json["z"] = face.height + position;
    json["inner_radius"] = face.inner;
    json["outer_radius"] = face.outer;
    json["text"] = roughnessText(face.roughness, roughnessGrade(face.roughness)) + ", face at Z " +
                   shownText(face.height + position) + ", Ø" + shownText(2.0 * face.inner) + " to Ø" +
                   shownText(2.0 * face.outer);
    all.push_back(std::move(json));
  }
  return all;
}

nlohmann::json sideJson(const TurnedPart& part, TurningSide side, double position) {
  nlohmann::json all = nlohmann::json::array();
  for (const FinishInterval& stretch : finishIntervals(part.finish, part.profile, side)) {
    if (all.size() == kMostStretches) break;
    all.push_back(stretchJson(part, stretch, position));
  }
  return all;
}

}  // namespace

nlohmann::json finishJson(const TurnedPart& part, double position) {
  return {{"outside", sideJson(part, TurningSide::Outside, position)},
          {"bore", sideJson(part, TurningSide::Bore, position)},
          {"faces", facesJson(part, position)}};
}

}  // namespace handwheel
