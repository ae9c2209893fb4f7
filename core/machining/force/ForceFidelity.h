// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "machining/force/WorkMaterials.h"

namespace handwheel {

// The force laws that the hand can feel, in the order of the setting's choices.
enum class ForceLaw { Kosilova, Kienzle, Network };

// Returns the setting turn.force_model, the law that gives the cutting force.
FidelitySetting forceModelSetting();

// Returns the chosen law for a material. Kienzle's law, which every material has, replaces Kosilova's law if the
// handbook has no row for the material. It also replaces the shipped network for any material but the one that the
// network was trained on.
std::unique_ptr<CuttingForceModel> forceModelFor(ForceLaw law, const WorkMaterial& material, const CuttingEdge& edge,
                                                 const ThrustSettings& thrust = {});

// The law that a force model follows.
struct LawInUse {
  ForceLaw law = ForceLaw::Kienzle;
  bool isVerified = true;  // all its constants were compared with their source
};
// Returns the law of a model that forceModelFor() made for this material.
LawInUse lawInUse(const CuttingForceModel& model, const WorkMaterial& material);

}  // namespace handwheel
