// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/clay/ClayContact.h"
#include "simulation/clay/ClaySimulation.h"

#include <memory>

namespace handwheel {

class HapticSceneBuilder;

// What the hand feels of voxels: the force source kClaySource in the haptic scene. Window thread.
class ClayTouch {
 public:
  explicit ClayTouch(HapticSceneBuilder& scene) : m_scene(scene) {}

  // The channel of a simulation, or of a volume that rests, and what its tool feels like. Null: nothing is felt.
  void set(const std::shared_ptr<ClayChannel>& channel, const ClayFeel& feel);

 private:
  HapticSceneBuilder& m_scene;
  std::shared_ptr<ClayChannel> m_channel;
  ClayFeel m_feel;
};

}  // namespace handwheel
