// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"
#include "haptics/device/ServoClock.h"
#include "haptics/servo/ForceRenderer.h"
#include "haptics/servo/HapticScene.h"

#include <functional>
#include <memory>

namespace handwheel::test {

// Returns the capabilities of a force device of 8 N with friction, like a Falcon. The friction is 5 N·s/m; the test
// controls the position of the device.
inline DeviceCapabilities forceDevice() {
  DeviceCapabilities device;
  device.buttons = 2;
  device.maxForce = 8.0;
  device.maxStiffness = 100.0;  // so that the rule of stiffness decides
  device.maxDamping = 0.02;
  device.workspaceRadius = 100.0;
  device.inherentDamping = 0.005;
  return device;
}

class ScriptedDevice : public Device {
 public:
  struct Log {
    DeviceState state;  // result of the next reading
    DeviceForce last;   // last written force
    int reads = 0;
    int writes = 0;
    int closes = 0;
    std::function<void(Log&)> onRead;                             // called before a reading
    std::function<void(const Log&, const DeviceForce&)> onWrite;  // called before it becomes the last
  };

  explicit ScriptedDevice(std::shared_ptr<Log> log, const DeviceCapabilities& capabilities = forceDevice())
      : m_log(std::move(log)), m_capabilities(capabilities) {
    m_log->state.status = DeviceStatus::Ready;
  }

  DeviceCapabilities capabilities() const override { return m_capabilities; }
  Status open(Progress) override { return Done{}; }
  void close() noexcept override { ++m_log->closes; }
  DeviceState read() noexcept override {
    if (m_log->onRead) m_log->onRead(*m_log);
    ++m_log->reads;
    return m_log->state;
  }
  void write(const DeviceForce& force) noexcept override {
    if (m_log->onWrite) m_log->onWrite(*m_log, force);
    ++m_log->writes;
    m_log->last = force;
  }

 private:
  std::shared_ptr<Log> m_log;
  DeviceCapabilities m_capabilities;
};

// A force that is a function of the tip.
class FunctionSource : public ForceRenderer {
 public:
  using Function = std::function<void(const TipState&, ForceOut&)>;
  explicit FunctionSource(Function function) : m_function(std::move(function)) {}
  void tick(const TipState& tip, ForceOut& out) noexcept override { m_function(tip, out); }
  void follow(const ForceRenderer& previous) noexcept override {
    followed = &previous;
    if (onFollow) onFollow();
  }

  const ForceRenderer* followed = nullptr;
  std::function<void()> onFollow;

 private:
  Function m_function;
};

// Returns a wall at x = 0 that fills x > 0, as stiff as requested and the loop allows, with a damping B (N·s/mm)
// inside.
inline FunctionSource::Function wall(double stiffness, double damping = 0.0) {
  return [=](const TipState& tip, ForceOut& out) {
    const double limit = tip.stiffnessLimit * (1.0 - damping / tip.dampingLimit);
    out.isSoftened = limit < stiffness;
    out.asked = stiffness;
    out.stiffness = std::min(stiffness, limit);
    out.isContact = tip.position.x() > 0.0;
    if (!out.isContact) return;
    out.proxy.x() = 0.0;
    out.force.x() = -out.stiffness * tip.position.x() - damping * tip.velocity.x();
  };
}

inline std::unique_ptr<HapticScene> sceneOf(FunctionSource::Function function, bool isDiscontinuous = true) {
  auto scene = std::make_unique<HapticScene>();
  scene->renderer = std::make_unique<FunctionSource>(std::move(function));
  scene->isDiscontinuous = isDiscontinuous;
  return scene;
}

// A clock whose waits end `late` ns after the requested time, as the test sets.
class LateClock : public VirtualClock {
 public:
  std::function<std::int64_t()> late;
  void waitUntil(std::int64_t time) noexcept override {
    VirtualClock::waitUntil(time);
    if (late) set(now() + late());
  }
};

inline constexpr std::int64_t kMillisecond = 1'000'000;  // ns

}  // namespace handwheel::test
