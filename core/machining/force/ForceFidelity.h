// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "machining/force/WorkMaterials.h"

namespace handwheel {

// The laws that the hand can feel; the choices of the setting, in its order.
enum class ForceLaw { Kosilova, Kienzle, Network };

// The setting turn.force_model: which law gives the cutting force.
FidelitySetting forceModelSetting();

// The law for a material by its choice. Kienzle's, which every material has, takes the place of Kosilova's where the
// handbook has no row, and of the network that ships for another material than its own.
std::unique_ptr<CuttingForceModel> forceModelFor(ForceLaw law, const WorkMaterial& material, const CuttingEdge& edge,
                                                 const ThrustSettings& thrust = {});

// The law that a force is from.
struct LawInUse {
  ForceLaw law = ForceLaw::Kienzle;
  bool isVerified = true;  // all that it comes from was compared with its source
};
// Of a model that forceModelFor() made for this material.
LawInUse lawInUse(const CuttingForceModel& model, const WorkMaterial& material);

}  // namespace handwheel
