// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/SculptOperations.h"

#include "mesh/sculpt/LaplaceSmoothing.h"
#include "mesh/sculpt/NoiseSmoothing.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/SharedParameters.h"
#include "tools/mesh/sculpt/SculptSettings.h"

#include <QtGlobal>

namespace handwheel {
namespace {

constexpr double kMostLevels = 20.0;  // each level has about four times the faces

Parameter radiusParameter() {
  return {.property = {.id = "radius",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Brush radius"),
                       .value = 0.0,
                       .quantity = Quantity::Length,
                       .least = 1e-9,
                       .largest = 1e9},
          .meaning = "Radius of the brush; required",
          .word = "MM",
          .hasDefault = false};
}

Parameter strengthParameter() {
  return {.property = {.id = "strength",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Strength"),
                       .value = SculptSettings().strength,
                       .least = -1.0,
                       .largest = 1.0,
                       .continuous = true},
          .meaning = "Strength of a dab; below 0 in the opposite direction",
          .word = "N"};
}

Parameter levelsParameter(const char* id, std::string meaning, double standard) {
  Parameter levels = countParameter(id, "N", std::move(meaning));
  levels.property.value = standard;
  levels.property.largest = kMostLevels;
  return levels;
}

Parameter levelParameter() {
  Parameter level = levelsParameter("level", "Level of the patch to sculpt; default: the finest", 0.0);
  level.hasDefault = false;
  return level;
}

Parameter noiseParameter() {
  return {.property = {.id = "angle",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Noise angle"),
                       .value = NoiseSmoothing().normalSpread,
                       .quantity = Quantity::Angle,
                       .least = NoiseSmoothing::kLeastSpread,
                       .largest = NoiseSmoothing::kLargestSpread},
          .meaning = "Normals that differ by less are noise",
          .word = "DEGREES"};
}

Parameter noiseMethodParameter() {
  return {.property = {.id = "method", .group = {}, .label = {}, .value = 0.0},  // in the order of NoiseMethod
          .meaning = "bilateral preserves sharp edges; laplace and bending round them",
          .word = "METHOD",
          .words = {"bilateral", "laplace", "bending"}};
}

Parameter passesParameter() {
  Parameter passes = countParameter("passes", "N", "Number of passes of laplace or bending");
  passes.property.value = static_cast<double>(LaplaceSmoothing().passes);
  passes.property.least = 1.0;
  passes.property.largest = 1000.0;
  return passes;
}

std::vector<Parameter> patchParameters() {
  std::vector<Parameter> all = {
      textParameter("patch", "TRIANGLES", "The triangles to work on, at the finest level"),
      levelsParameter("finest", "Number of subdivisions; the coarser levels are in the document", 0.0)};
  for (Parameter& parameter : all) parameter.bundle = "PATCH";
  return all;
}

std::vector<Parameter> around(std::vector<Parameter> before, std::vector<Parameter> after) {
  for (Parameter& parameter : patchParameters()) before.push_back(std::move(parameter));
  for (Parameter& parameter : after) before.push_back(std::move(parameter));
  return before;
}

Parameter bordersParameter() {
  return flagParameter("borders", "Move vertices of open edges, too",
                       QT_TRANSLATE_NOOP("Property", "Move boundary vertices, too"));
}

}  // namespace

std::vector<Operation> sculptOperations() {
  return {
      {.id = "stroke",
       .title = QT_TRANSLATE_NOOP("Tool", "Sculpt"),
       .meaning = "A stroke of the brush drag, smooth, inflate or flatten; PLACE: TRIANGLE:X,Y,Z; drag has one",
       .operands = "BRUSH PLACE...",
       .parameters = around({pointParameter("by", "Displacement of drag; required"), radiusParameter(),
                             strengthParameter(), bordersParameter()},
                            {levelParameter(), numbersParameter()})},
      {.id = "subdivide",
       .title = QT_TRANSLATE_NOOP("Tool", "Subdivide patch"),
       .meaning = "Subdivide by one level; a patch is required",
       .parameters = around({}, {levelsParameter("times", "Number of levels", 1.0), numbersParameter()})},
      {.id = "refine",
       .title = QT_TRANSLATE_NOOP("Tool", "Refine to the surroundings"),
       .meaning = "Remesh to even triangles as long as the edges around; a patch is required",
       .parameters = around({}, {numbersParameter()})},
      {.id = "level-back",
       .title = QT_TRANSLATE_NOOP("Tool", "One level back"),
       .meaning = "Remove the finest level of a patch",
       .parameters = patchParameters()},
      {.id = "smooth-noise",
       .title = QT_TRANSLATE_NOOP("Tool", "Smooth noise"),
       .meaning = "Smooth noise of a patch; without one along open edges",
       .parameters = around(
           {}, {noiseMethodParameter(), noiseParameter(), passesParameter(), bordersParameter(), numbersParameter()})},
  };
}

}  // namespace handwheel
