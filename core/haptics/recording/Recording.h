// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "haptics/servo/ForceRenderer.h"
#include "haptics/servo/ServoSample.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// One recorded tick of the servo loop, sufficient to plot and replay it.
struct RecordedTick {
  std::uint64_t tick = 0;
  TipState tip;
  ForceOut felt;
  DeviceForce sent;
  Vec3 devicePosition = Vec3::Zero();  // mm, as read from the device: may not be finite when it failed
  std::uint32_t actions = 0;           // bits of SafetyAction
  float microseconds = 0.0;            // from reading the device to writing it
  DeviceStatus status = DeviceStatus::Absent;
  bool hasSource = false;  // the scene's force was computed
};

// Converts a sample of the servo loop to a recorded tick.
RecordedTick recorded(const ServoSample& sample);

// An event during a recording: a tool was chosen, the user set a mark. Its tick is the one before it; that of a scene
// is its first.
struct RecordedEvent {
  std::uint64_t tick = 0;
  std::string text;
};

// Prefix of an event that describes the contents of a scene, in words of its creator.
inline constexpr std::string_view kSceneEvent = "scene ";

// A sequence of recorded ticks with events. 368 bytes per tick. A copy shares them and is cheap.
class Recording {
 public:
  void add(const RecordedTick& tick);
  void addEvent(RecordedEvent event) { m_events.push_back(std::move(event)); }
  void append(const Recording& later);

  std::size_t size() const { return m_ticks.size(); }
  const RecordedTick& operator[](std::size_t i) const { return m_ticks[i]; }
  const std::vector<RecordedEvent>& events() const { return m_events; }
  // Returns the number of ticks missing between the first and the last.
  std::uint64_t missing() const { return m_missing; }
  // Returns the time from the first tick to the last, s; never negative.
  double duration() const;

  // Replays the recorded tips on the scenes that they were in, in order, and calls visit(const RecordedTick&, const
  // ForceOut&) for each tick in which the scene's force was computed. sceneAt(const RecordedTick&) returns the scene of
  // a tick, which has followed the one before it (ForceRenderer::follow()), or null: the tick is left out. Scenes in
  // the same states as those at the recording give the same forces, bit for bit.
  template <class SceneAt, class Visit>
  void replay(SceneAt sceneAt, Visit visit) const {
    for (std::size_t i = 0; i < size(); ++i) {
      const RecordedTick& tick = m_ticks[i];
      ForceRenderer* const scene = sceneAt(tick);
      if (!tick.hasSource || !scene) continue;
      ForceOut felt;
      felt.proxy = tick.tip.position;
      scene->tick(tick.tip, felt);
      visit(tick, static_cast<const ForceOut&>(felt));
    }
  }

 private:
  PagedArray<RecordedTick> m_ticks;
  std::vector<RecordedEvent> m_events;
  std::uint64_t m_missing = 0;
};

}  // namespace handwheel
