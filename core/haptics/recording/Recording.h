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

// One recorded tick of the servo loop. It is sufficient for plotting and replaying the tick.
struct RecordedTick {
  std::uint64_t tick = 0;
  TipState tip;
  ForceOut felt;
  DeviceForce sent;
  Vec3 devicePosition = Vec3::Zero();  // mm, as read from the device; may not be finite if the device failed
  std::uint32_t actions = 0;           // bits of SafetyAction
  float microseconds = 0.0;            // time from reading the device to writing it
  DeviceStatus status = DeviceStatus::Absent;
  bool hasSource = false;  // true: the scene's force was computed
};

// Converts a sample of the servo loop to a recorded tick.
RecordedTick recorded(const ServoSample& sample);

// An event during a recording, for example a choice of a tool or a mark of the user. Its tick is the last tick before
// the event. The tick of the event of a scene is the first tick in that scene.
struct RecordedEvent {
  std::uint64_t tick = 0;
  std::string text;
};

// Prefix of an event that describes the contents of a scene. The creator of the scene writes the description.
inline constexpr std::string_view kSceneEvent = "scene ";

// A sequence of recorded ticks with events. It takes 368 bytes per tick. A copy shares the ticks and is cheap.
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
  // Returns the time from the first tick to the last, s. It is never negative.
  double duration() const;

  // Replays the recorded tips on their scenes, in order. Calls visit(const RecordedTick&, const ForceOut&) for each
  // tick in which the scene's force was computed. sceneAt(const RecordedTick&) returns the scene of a tick, which has
  // followed the previous scene (ForceRenderer::follow()), or null if the tick is to be omitted. If the scenes are in
  // the same states as during the recording, the forces are the same, bit for bit.
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
