// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheMaterial.h"

#include "machining/force/DrillForceModel.h"

#include <cmath>

namespace handwheel {

namespace {

// Returns the modulus by the group of ISO 513, rounded: tables of constants have it only for alloys.
double modulusOf(const WorkMaterial& material) {
  constexpr double kSteel = 210e3, kIron = 120e3, kAluminium = 70e3, kCopper = 110e3;  // N/mm²
  if (material.group == 'K') return kIron;
  if (material.group != 'N') return kSteel;
  return material.id.find("aluminium") != std::string::npos ? kAluminium : kCopper;
}

}  // namespace

CuttingEdge edgeOf(const LatheTool& tool) {
  CuttingEdge edge;
  edge.approach = tool.enteringAngle * M_PI / 180.0;
  edge.rake = tool.rake * M_PI / 180.0;
  edge.noseRadius = tool.noseRadius;
  return edge;
}

CuttingEdge edgeOf(const TurningPass& pass) {
  if (pass.tool) return edgeOf(*pass.tool);
  CuttingEdge edge;
  edge.noseRadius = pass.noseRadius;
  return edge;
}

LatheMaterial latheMaterial(const WorkMaterial& material, ForceLaw law, const LatheTools& tools) {
  LatheMaterial made;
  made.id = material.id;
  made.law = law;
  made.modulus = modulusOf(material);
  for (const auto& tool : tools) {
    std::unique_ptr<const CuttingForceModel> model;
    if (!tool->isAbrasive()) model = forceModelFor(law, material, edgeOf(*tool));
    if (tool->kind == LatheToolKind::Drill) model = std::make_unique<DrillForceModel>(std::move(model));
    made.laws.push_back(std::move(model));
  }
  return made;
}

}  // namespace handwheel
