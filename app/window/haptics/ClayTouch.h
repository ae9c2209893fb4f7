// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/clay/ClayContact.h"
#include "simulation/clay/ClaySimulation.h"

#include <memory>

namespace handwheel {

class HapticSceneBuilder;

// Makes voxels touchable by the force source kClaySource in the haptic scene. Must be used on the window thread.
class ClayTouch {
 public:
  explicit ClayTouch(HapticSceneBuilder& scene) : m_scene(scene) {}

  // Sets the channel of a simulation, or of a volume at rest, and the feel of its tool. channel: null: no force.
  void set(const std::shared_ptr<ClayChannel>& channel, const ClayFeel& feel);

 private:
  HapticSceneBuilder& m_scene;
  std::shared_ptr<ClayChannel> m_channel;
  ClayFeel m_feel;
};

}  // namespace handwheel
