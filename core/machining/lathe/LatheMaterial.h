// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/ForceFidelity.h"
#include "machining/lathe/LatheTool.h"

namespace handwheel {

// The mechanical properties of a part's material on the lathe. They are the laws of the cutting forces of its tools,
// and its stiffness.
struct LatheMaterial {
  std::string id;                                              // of the work material
  ForceLaw law = ForceLaw::Kienzle;                            // as it was chosen
  std::vector<std::shared_ptr<const CuttingForceModel>> laws;  // as the tools; null: one that does not cut chips
  double modulus = 210e3;                                      // N/mm², of elasticity

  // Of the tool with this place in the list; null: none.
  const CuttingForceModel* lawOf(std::size_t tool) const { return tool < laws.size() ? laws[tool].get() : nullptr; }
};

// The edge of a tool as the laws see it.
CuttingEdge edgeOf(const LatheTool& tool);

// The laws of the chosen kind for all tools. Milliseconds.
LatheMaterial latheMaterial(const WorkMaterial& material, ForceLaw law, const LatheTools& tools);

}  // namespace handwheel
