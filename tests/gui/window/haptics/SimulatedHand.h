// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/haptics/HapticSession.h"

namespace handwheel::test {

// Moves the simulated hand of a session to a position in the scene.
inline void leadHandTo(HapticSession& session, const Vec3& position, std::uint32_t buttons) {
  const WorkspaceMapping mapping = session.mappingInScene();
  HandPose pose;
  pose.position = mapping.viewFromDevice().transpose() * (mapping.sceneFromView.inverse() * position) / mapping.scale;
  pose.buttons = buttons;
  session.simulatedHand()->setTarget(pose);
}

}  // namespace handwheel::test
