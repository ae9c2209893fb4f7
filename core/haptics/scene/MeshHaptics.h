// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/scene/SnapForce.h"
#include "haptics/scene/SpringForce.h"
#include "haptics/scene/SurfaceForce.h"

#include <optional>

namespace handwheel {

// The haptic representation of a mesh: surface, snap features, and springs of a tool.
struct MeshHaptics {
  std::optional<TouchedSurface> surface;
  std::optional<SnapAttraction> snap;
  std::vector<Spring> springs;
  Vec3 comesFrom = Vec3::Zero();  // direction from which the tip approaches, see SurfaceForce
};

// Ids of the force sources that forceSources() creates.
inline constexpr const char* kSurfaceSource = "surface";
inline constexpr const char* kSnapSource = "snap";
inline constexpr const char* kSpringSource = "springs";

// Returns the force sources of a mesh. Parts of its representation that are absent cost nothing.
ForceSources forceSources(MeshHaptics mesh);

}  // namespace handwheel
