// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/force/ForceFidelity.h"
#include "machining/lathe/LatheTool.h"

namespace handwheel {

// The mechanical properties of a part's material on the lathe. They are the laws of the cutting forces for each tool,
// and the stiffness of the material.
struct LatheMaterial {
  std::string id;                                              // id of the work material
  ForceLaw law = ForceLaw::Kienzle;                            // the chosen law
  std::vector<std::shared_ptr<const CuttingForceModel>> laws;  // one for each tool; null: the tool does not cut chips
  double modulus = 210e3;                                      // N/mm², modulus of elasticity

  // Returns the law of the tool with this index, or null if it has none.
  const CuttingForceModel* lawOf(std::size_t tool) const { return tool < laws.size() ? laws[tool].get() : nullptr; }
};

// Returns the edge of a tool, with the angles that the force laws need.
CuttingEdge edgeOf(const LatheTool& tool);
// Returns the edge that cut a pass: that of its tool, or only the nose radius if the tool is not known.
CuttingEdge edgeOf(const TurningPass& pass);

// Returns the properties of a material with laws of the chosen kind for all tools. The call takes milliseconds.
LatheMaterial latheMaterial(const WorkMaterial& material, ForceLaw law, const LatheTools& tools);

}  // namespace handwheel
