// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheJson.h"
#include "machining/lathe/LatheRun.h"

#include <algorithm>
#include <cmath>

namespace handwheel::test {

using Lever = LatheCommand::Kind;
using Rule = CutWarning::Rule;

inline constexpr StockCylinder kLoadedShaft{40.0, 100.0, 0.0};
inline constexpr double kTick = 0.001;  // s

// A law of 2000 N for each mm² of the chip. There is no component across but the radial one.
class AreaLaw : public CuttingForceModel {
 public:
  explicit AreaLaw(double radial) : m_radial(radial) {}
  CutForces at(const CutConditions& cut) const noexcept override {
    const double area = cut.depth * cut.feed;
    return {2000.0 * area, 0.0, m_radial * area};
  }
  bool covers(const CutConditions&) const noexcept override { return true; }

 private:
  double m_radial;
};

inline LatheSetup setupWith(double power, double torque) {
  LatheSetup setup = defaultLatheSetup(kLoadedShaft);
  for (LatheSlot& slot : setup.stations) slot.position = slot.offset = {0.0, 0.0};
  setup.spindle.power = power;
  setup.spindle.torque = torque;
  return setup;
}

// A lathe that turns a depth off its shaft by the feed.
struct LoadedLathe {
  explicit LoadedLathe(const LatheSetup& setup, double radial = 0.0, const StockCylinder& bar = kLoadedShaft,
                       double spacing = 0.05)
      : run(setup, shippedLatheTools(), TurnedProfile(bar, spacing), LatheMachine::initialState(setup, bar),
            materialOf(radial)) {}

  static std::shared_ptr<const LatheMaterial> materialOf(double radial) {
    LatheMaterial material;
    material.laws.assign(shippedLatheTools().size(), std::make_shared<AreaLaw>(radial));
    return std::make_shared<const LatheMaterial>(std::move(material));
  }
  void send(LatheCommand command) { run.step(kTick, std::vector<LatheCommand>{command}); }
  void pass(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kTick)); ++i) run.step(kTick, {});
  }
  void turnDown(double r, double feed, double seconds) {
    const double length = run.profile().length();
    send({Lever::Spindle, LatheAxis::Carriage, 1.0});
    send({Lever::MoveTip, LatheAxis::Carriage, r, length + 1.0});
    pass(2.0);
    send({Lever::Feed, LatheAxis::Carriage, -feed});
    pass(seconds);
  }
  const LatheWarning* warningOf(Rule rule) const {
    const auto& all = run.warnings().all();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& w) { return w.warning.rule == rule; });
    return found == all.end() ? nullptr : &*found;
  }
  double radiusAt(double z) const {
    return run.profile().radius(static_cast<std::size_t>(std::lround(z / run.profile().spacing())));
  }
  double speed() const { return run.machine().state().speed; }

  LatheRun run;
};

}  // namespace handwheel::test
