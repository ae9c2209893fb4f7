// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheJson.h"
#include "machining/lathe/LatheRun.h"

#include <algorithm>
#include <cmath>

namespace handwheel::test {

// A lathe at work on a bar of 40 mm by 100 mm. With exactSetup(), the read-out shows the true positions of the tools.
class Lathe {
 public:
  using CommandKind = LatheCommand::Kind;
  static constexpr StockCylinder kBlank{40.0, 100.0, 0.0};
  static constexpr double kStep = 0.001;  // s

  explicit Lathe(LatheSetup setup = exactSetup(), double spacing = 0.02)
      : run(setup, shippedLatheTools(), TurnedProfile(kBlank, spacing), LatheMachine::initialState(setup, kBlank)) {}
  Lathe(const LatheSetup& setup, TurnedProfile part)
      : run(setup, shippedLatheTools(), std::move(part), LatheMachine::initialState(setup, kBlank)) {}

  static LatheSetup exactSetup() {
    LatheSetup setup = defaultLatheSetup(kBlank);
    for (LatheSlot& slot : setup.stations) slot.position = slot.offset = {0.0, 0.0};
    return setup;
  }

  LatheStep once(std::initializer_list<LatheCommand> commands = {}) {
    return run.step(kStep, std::vector<LatheCommand>(commands));
  }
  void pass(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep)); ++i) {
      const LatheStep step = once();
      removed += step.cut.volume;
      deepest = std::max(deepest, step.cut.depth);
    }
  }
  // Moves the tip to a position. The part must not obstruct the motion, and nothing may hold the tool.
  void go(double r, double z) {
    once({{CommandKind::MoveTip, LatheAxis::Carriage, r, z}});
    for (int i = 0; i < 20000 && (run.machine().tip() - ProfilePoint(r, z)).norm() > 1e-9; ++i)
      removed += once().cut.volume;
  }
  void spindle(double speed) {
    once({{CommandKind::Spindle, LatheAxis::Carriage, 1.0}, {CommandKind::Speed, LatheAxis::Carriage, speed}});
    pass(speed / run.machine().setup().spindle.acceleration + 0.01);
  }
  double radiusAt(double z) const {
    return run.profile().radius(static_cast<std::size_t>(std::lround(z / run.profile().spacing())));
  }
  double innerAt(double z) const {
    return run.profile().inner(static_cast<std::size_t>(std::lround(z / run.profile().spacing())));
  }

  LatheRun run;
  double removed = 0.0, deepest = 0.0;
};

}  // namespace handwheel::test
