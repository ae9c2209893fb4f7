// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "haptics/servo/RealTimeThread.h"
#include "haptics/servo/ServoTick.h"

#include <atomic>
#include <memory>
#include <thread>

namespace handwheel {

// Runs the servo loop of a device at a fixed rate on its own thread. The ticks are on a fixed time grid: a late tick
// does not delay the next, and missed ticks are skipped and counted, never made up for in a burst.
//
// Unless stated otherwise, functions must be called on the thread that owns the loop, which is the window thread.
class ServoLoop {
 public:
  // The device must be open, and belongs to the loop from now on. The clock and the service must outlive the loop. The
  // service counts the ticks, and the time from waking to the end of each.
  ServoLoop(std::unique_ptr<Device> device, const ServoSettings& settings, ServoClock& clock, Service& service);
  // Stops the loop and closes the device, which may take seconds. Must be called on a worker thread, when no other
  // thread uses the loop any more.
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  void start();
  void stop();  // sends zero force at the end
  bool isRunning() const { return m_thread.joinable(); }
  // Sets rate and velocity window. The loop must be stopped. The tick count continues, scene and mapping stay, and the
  // force returns by the ramp. References returned by measure() become invalid. The sample capacity does not change.
  void setSettings(const ServoSettings& settings);
  // Runs ticks on the calling thread instead of the thread of the loop. It is for tests and the command line, with a
  // virtual clock.
  void runTicks(std::uint64_t count);

  // Sets the scene for the next tick, and frees scenes that the loop no longer uses. If a discontinuous scene is
  // replaced before a tick has used it, its discontinuity still starts the ramp.
  void setScene(std::unique_ptr<HapticScene> scene) {
    if (scene->isDiscontinuous) announceDiscontinuity();
    scene->mapping = m_mapping;
    scene->number = ++m_sceneNumber;
    m_channel->scenes.publish(std::move(scene));
  }
  // Returns the number of the scene that was set last.
  std::uint64_t sceneNumber() const { return m_sceneNumber; }
  // Sets the mapping from the next tick on, and optionally a scene that was made for it: a tick uses both or neither. A
  // mapping that does not keep the tip starts the ramp. Before a change of axes, which turns the force,
  // announceDiscontinuity() must be called.
  void setMapping(const WorkspaceMapping& mapping, std::unique_ptr<HapticScene> scene = nullptr) {
    m_mapping = {m_mapping.number + 1, mapping};
    if (scene) setScene(std::move(scene));
    m_channel->mapping.write(m_mapping);
  }
  // Frees scenes that were replaced. It should be called regularly, so that their memory is not held until the next
  // setScene().
  bool collect() { return m_channel->scenes.collect(); }
  // Starts the ramp before a possible discontinuity within the scene, for example when a tool or snapping is switched.
  void announceDiscontinuity() { m_channel->isDiscontinuous.store(true, std::memory_order_release); }
  void setForceOn(bool isOn) { m_channel->isForceOn.store(isOn, std::memory_order_relaxed); }

  // Fetches the next sample. Must be called by one thread only, that of the recorder. Returns false if there is no
  // sample.
  bool nextSample(ServoSample& sample) { return m_channel->samples.pop(sample); }
  std::uint64_t droppedSamples() const { return m_channel->samples.dropped(); }
  // Returns the data of the last tick. Must be called by one thread only, the window thread.
  const ServoSample& latest() { return m_channel->latest.read(); }

  // The following functions may be called on any thread.
  RealTimeState realTime() const { return m_realTime.load(std::memory_order_relaxed); }
  std::uint64_t missedTicks() const { return m_missed.load(std::memory_order_relaxed); }
  const ServoStatistics& measure() const { return m_tick->measure(); }
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
  NumberedMapping m_mapping;  // the mapping that was set last
  std::uint64_t m_sceneNumber = 0;
  std::int64_t m_due = 0;  // due time of the next tick, ns
  std::thread m_thread;
  std::atomic<bool> m_isStopping{false};
  std::atomic<RealTimeState> m_realTime{RealTimeState::NotRunning};
  std::atomic<std::uint64_t> m_missed{0};
};

}  // namespace handwheel
