// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/scene/MeshHaptics.h"

namespace handwheel {

ForceSources forceSources(MeshHaptics mesh) {
  ForceSources all;
  if (mesh.surface)
    all.push_back(std::make_unique<SurfaceForce>(kSurfaceSource, std::move(*mesh.surface), mesh.comesFrom));
  if (mesh.snap) all.push_back(std::make_unique<SnapForce>(kSnapSource, std::move(*mesh.snap)));
  if (!mesh.springs.empty()) all.push_back(std::make_unique<SpringForce>(kSpringSource, std::move(mesh.springs)));
  return all;
}

}  // namespace handwheel
