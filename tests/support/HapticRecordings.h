// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "HapticDevices.h"
#include "haptics/device/SimulatedDevice.h"
#include "haptics/recording/ForceRecorder.h"

namespace handwheel::test {

// A force source with memory. Its proxy follows the tip with a delay, and its force depends on all of its input.
class StickyWall : public ForceRenderer {
 public:
  void tick(const TipState& tip, ForceOut& out) noexcept override {
    if (tip.isRestart) m_proxy = tip.position;
    m_proxy += (1.0 - std::exp(-20.0 * tip.period)) * (tip.position - m_proxy);
    out.proxy = m_proxy;
    out.isContact = tip.position.x() > 0.0;
    const double stiffness = std::min(0.4, tip.stiffnessLimit);
    out.force = stiffness * (m_proxy - tip.position) + Vec3(0, 0.1 * std::sin(7.0 * tip.time), 0);
    out.force -= 0.0001 * tip.velocity;
    out.torque = 3.0 * (tip.orientation * Vec3::UnitX());
    out.gripper = tip.buttons;
    out.stiffness = stiffness;
  }

 private:
  Vec3 m_proxy = Vec3::Zero();
};

// A run of a simulated hand with dynamics that touches a sticky wall, with a recorder. The virtual clock delays some of
// the ticks.
struct RecordedRun {
  LateClock clock;
  Service service{"servo"};
  std::unique_ptr<ServoLoop> loop;
  std::unique_ptr<ForceRecorder> recorder;

  RecordedRun() {
    clock.late = [n = std::int64_t{0}]() mutable { return ++n * 7919 % 300 * 1000; };
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.7, Vec3::UnitY()));
    const PoseTrajectory path({{0.0, {-1, 0, 0}}, {1.0, {2, 1, 0}, turned, 1}, {2.0, {-1, 3, 1}, turned, 0}});
    auto device = std::make_unique<SimulatedDevice>(simulatedDevice(), path, clock);
    if (!device->open(Progress())) return;
    loop = std::make_unique<ServoLoop>(std::move(device), ServoSettings(), clock, service);
    recorder = std::make_unique<ForceRecorder>(*loop);
    auto scene = std::make_unique<HapticScene>();
    scene->renderer = std::make_unique<StickyWall>();
    loop->setScene(std::move(scene));
  }

  Recording record(int ticks) {
    for (int i = 0; i < ticks; i += 1000) {
      loop->runTicks(static_cast<std::uint64_t>(std::min(1000, ticks - i)));
      recorder->fetch();
    }
    return recorder->recording();
  }
};

}  // namespace handwheel::test
