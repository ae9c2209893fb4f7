// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/clay/ClayContact.h"
#include "simulation/clay/ClaySimulation.h"
#include "tools/Tool.h"

namespace handwheel {

// The preview of a volume while a tool works on it.
struct VolumePreview : KindPreview {
  std::shared_ptr<const ClayState> state;
};

// Base class of tools that change a volume through a simulation. The tools are felt at a device.
class VolumeTool : public Tool {
 public:
  // The channel between the force source of the tool and its simulation, for the haptic scene.
  const std::shared_ptr<ClayChannel>& channel() const { return m_channel; }
  // Returns the settings of the contact at a device.
  virtual ClayFeel feelAtDevice() const = 0;

 private:
  std::shared_ptr<ClayChannel> m_channel = std::make_shared<ClayChannel>();
};

}  // namespace handwheel
