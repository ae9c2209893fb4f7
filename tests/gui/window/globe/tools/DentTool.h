// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "SimulationLog.h"
#include "globe/document/GlobeDocument.h"
#include "globe/simulation/DentSimulation.h"
#include "simulation/SimulatedGesture.h"
#include "tools/Tool.h"

namespace handwheel::test {

// Id of the service that tools for dents require.
inline constexpr const char* kDentService = "globe_dents";

// Tool that dents a globe while a button is held. The dent is at the tip of a haptic device, or slightly below the
// surface at the mouse pointer.
class DentTool : public Tool {
 public:
  static constexpr double kRate = 250.0;  // steps of the simulation per second
  static constexpr double kPress = 0.2;   // depth of the mouse's dent below the surface, as a fraction of the radius

  DentTool(GlobeDocument& document, const SimulationServices& services);

  // Channel from the simulation to the haptic scene.
  const std::shared_ptr<DentChannel>& channel() const { return m_channel; }
  // Log of the last gesture that was committed.
  const SimulationLog& lastGesture() const { return m_lastGesture; }

  std::string id() const override { return "dent"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  bool isLive() const override { return m_gesture.isOn(); }
  void documentChanged() override { m_gesture.restart(); }
  std::vector<std::string> needs() const override { return {kDentService}; }

 private:
  std::unique_ptr<Simulation> simulation() const;
  void feed(const PointerEvent& event);
  ToolReply press(const PointerEvent& event);
  ToolReply release();

  GlobeDocument& m_document;
  std::shared_ptr<DentChannel> m_channel = std::make_shared<DentChannel>();
  SimulatedGesture m_gesture;
  SimulationLog m_lastGesture;
};

}  // namespace handwheel::test
