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

// Returns the capabilities of a force device with friction, like a Falcon. Its largest force is 8 N, its
// friction is 5 N·s/m. The test controls the position of the device.
inline DeviceCapabilities forceDevice() {
  DeviceCapabilities device;
  device.buttons = 2;
  device.maxForce = 8.0;
  device.maxStiffness = 100.0;  // high, so that stiffnessLimit() of the loop sets the limit
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
    std::function<void(Log&)> onRead;                             // function called before each reading
    std::function<void(const Log&, const DeviceForce&)> onWrite;  // function called before `last` is set
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

// A force source that calls a function of the state of the tip.
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

// Returns the function of a wall that fills x > 0. Its stiffness is the requested one, or less if the loop requires it;
// the damping acts inside, N·s/mm.
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

// A clock that ends its waits late, by the number of ns that the function `late` returns.
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
