// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/ClayTouch.h"

#include "simulation/clay/ClayForce.h"
#include "window/haptics/HapticSceneBuilder.h"

namespace handwheel {

void ClayTouch::set(const std::shared_ptr<ClayChannel>& channel, const ClayFeel& feel) {
  const bool isSame = channel == m_channel;
  if (isSame && (!channel || feel == m_feel)) return;  // without one, another kind of document may have the source
  m_channel = channel;
  m_feel = feel;
  if (!channel) return m_scene.setSource(kClaySource, {}, false);
  const auto make = [channel, feel](const TouchContext& context) {
    ClayFeel inScene = feel;
    inScene.stiffness = context.mapping.sceneStiffness(context.touch.stiffness);
    // The resistance of a drill follows from its thrust in the scene, as in its simulation.
    if (feel.spindle == 0.0) inScene.resistance = context.mapping.sceneStiffness(feel.resistance);
    return std::make_unique<ClayForce>(channel, inScene);
  };
  m_scene.setSource(kClaySource, make, isSame);
}

}  // namespace handwheel
