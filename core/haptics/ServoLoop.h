// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "haptics/RealTimeThread.h"
#include "haptics/ServoTick.h"

#include <atomic>
#include <memory>
#include <thread>

namespace handwheel {

// Runs the ticks of one device on a thread of its own at a fixed rate. The ticks lie on a grid: one that comes late
// does not move the next, and ticks that were missed are left out and counted, never made up for in a burst.
// Where nothing else is said, functions are called on the thread that owns it, the window's.
class ServoLoop {
 public:
  // The device is open and belongs to the loop from now on. The clock and the service outlive it; the service counts
  // ticks and the time from waking to the end of each.
  ServoLoop(std::unique_ptr<Device> device, const ServoSettings& settings, ServoClock& clock, Service& service);
  // Stops, and closes the device, which may take its time: on a worker, when nothing else uses the loop any more.
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  void start();
  void stop();  // the last thing sent is zero force
  bool isRunning() const { return m_thread.joinable(); }
  // Another rate and window, while it is stopped: ticks are counted on, scene and mapping stay, and the force comes
  // back by the ramp. What measure() has said is of the past, its reference too. How many samples may wait does not
  // change.
  void setSettings(const ServoSettings& settings);
  // Instead of a thread, on the calling one: for tests and the command line, by a virtual clock.
  void runTicks(std::uint64_t count);

  // The next tick feels this scene. Frees what the loop has left. A leap that was announced with one that no tick has
  // felt still starts the ramp.
  void setScene(std::unique_ptr<HapticScene> scene) {
    if (scene->mayLeap) announceLeap();
    scene->mapping = m_mapping;
    m_channel->scenes.publish(std::move(scene));
  }
  // Where the device lies in the scene from the next tick on, and a scene that was made for it: a tick feels both or
  // neither. A mapping that does not keep the tip starts the ramp; of a change of axes, which turns the force about,
  // announceLeap() tells before.
  void setMapping(const WorkspaceMapping& mapping, std::unique_ptr<HapticScene> scene = nullptr) {
    m_mapping = {m_mapping.number + 1, mapping};
    if (scene) setScene(std::move(scene));
    m_channel->mapping.write(m_mapping);
  }
  // To be called now and then, so that memory of a scene that was replaced does not wait for the next.
  bool collect() { return m_channel->scenes.collect(); }
  // Something within the scene may make the force leap, a tool or a snap that was switched: starts the ramp.
  void announceLeap() { m_channel->mayLeap.store(true, std::memory_order_release); }
  void setForceOn(bool isOn) { m_channel->isForceOn.store(isOn, std::memory_order_relaxed); }

  // The next tick that was not fetched yet; by one thread, the recorder's. False: none.
  bool nextSample(ServoSample& sample) { return m_channel->samples.pop(sample); }
  std::uint64_t droppedSamples() const { return m_channel->samples.dropped(); }
  // The last tick; by one thread, the window's.
  const ServoSample& latest() { return m_channel->latest.read(); }

  // Any thread.
  RealTimeState realTime() const { return m_realTime.load(std::memory_order_relaxed); }
  std::uint64_t missedTicks() const { return m_missed.load(std::memory_order_relaxed); }
  const LoopMeasure& measure() const { return m_tick->measure(); }
  const Device& device() const { return *m_device; }

 private:
  void run();
  void cycle() noexcept;
  std::int64_t dueAfter(std::int64_t due, std::int64_t now);
  void rest() noexcept;

  const std::unique_ptr<Device> m_device;
  ServoClock& m_clock;
  Service& m_service;
  const std::unique_ptr<ServoChannel> m_channel;
  std::unique_ptr<ServoTick> m_tick;
  int m_priority;
  std::int64_t m_period;      // ns
  NumberedMapping m_mapping;  // as it was set last
  std::int64_t m_due = 0;     // ns: when the next tick is to come
  std::thread m_thread;
  std::atomic<bool> m_isStopping{false};
  std::atomic<RealTimeState> m_realTime{RealTimeState::NotRunning};
  std::atomic<std::uint64_t> m_missed{0};
};

}  // namespace handwheel
