// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/ForceFidelity.h"

#include "base/Translatable.h"
#include "machining/force/DrillForceModel.h"
#include "machining/force/TrainedForceModel.h"

namespace handwheel {

FidelitySetting forceModelSetting() {
  FidelitySetting s;
  s.id = "turn.force_model";
  s.label = translatable("Fidelity", "Law of the cutting force");
  setChoices(s, {"kosilova", "kienzle", "network"});  // in the order of ForceLaw
  s.standard = static_cast<double>(ForceLaw::Kienzle);
  s.presets = {1.0, 1.0, 1.0};
  s.error = {translatable("Fidelity", "largest difference from the cited tables"), "%"};
  s.cost = {translatable("Fidelity", "CPU time of one force"), "us"};
  s.budget = FidelityBudget::None;  // a hundredth of a tick
  return s;
}

std::unique_ptr<CuttingForceModel> forceModelFor(ForceLaw law, const WorkMaterial& material, const CuttingEdge& edge,
                                                 const ThrustSettings& thrust) {
  if (law == ForceLaw::Kosilova) {
    if (auto model = kosilovaModel(KosilovaTables::standard(), material, edge, thrust)) return model;
  }
  if (law == ForceLaw::Network) {
    auto model = std::make_unique<TrainedForceModel>(shippedForceModel(edge, thrust));
    if (model->origin().material == material.id) return model;
  }
  return kienzleModel(material, edge, thrust);
}

LawInUse lawInUse(const CuttingForceModel& model, const WorkMaterial& material) {
  if (const auto* drill = dynamic_cast<const DrillForceModel*>(&model)) return lawInUse(drill->turning(), material);
  if (const auto* handbook = dynamic_cast<const KosilovaModel*>(&model))
    return {ForceLaw::Kosilova, handbook->isVerified() && !handbook->hasThrustLaws()};
  if (dynamic_cast<const TrainedForceModel*>(&model)) return {ForceLaw::Network, true};
  return {ForceLaw::Kienzle, material.isVerified};
}

}  // namespace handwheel
