// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "haptics/ForceSource.h"
#include "haptics/ServoSample.h"

#include <cstdint>
#include <string>
#include <vector>

namespace handwheel {

// What is kept of a tick: enough to plot it, and to feel it again.
struct RecordedTick {
  std::uint64_t tick = 0;
  TipState tip;
  ForceOut felt;
  DeviceForce sent;
  Vec3 devicePosition = Vec3::Zero();  // mm, as the device said it: may be no number when it failed
  std::uint32_t actions = 0;           // bits of SafetyAction
  float microseconds = 0.0;            // from reading the device to writing it
  DeviceStatus status = DeviceStatus::Absent;
  bool hasSource = false;  // the scene was asked
};

RecordedTick recorded(const ServoSample& sample);

// Something that happened, at the tick before it: a tool taken, a mark set by the user.
struct RecordedEvent {
  std::uint64_t tick = 0;
  std::string text;
};

// The ticks of a stretch of time, 368 bytes each. A copy shares them and costs next to nothing.
class Recording {
 public:
  void add(const RecordedTick& tick);
  void addEvent(RecordedEvent event) { m_events.push_back(std::move(event)); }
  void append(const Recording& later);

  std::size_t size() const { return m_ticks.size(); }
  const RecordedTick& operator[](std::size_t i) const { return m_ticks[i]; }
  const std::vector<RecordedEvent>& events() const { return m_events; }
  // Ticks between the first and the last that are not here.
  std::uint64_t missing() const { return m_missing; }
  // s, from the first tick to the last; never negative.
  double duration() const;

  // Gives the recorded tips to a source, in order, and calls visit(const RecordedTick&, const ForceOut&) for each tick
  // in which the scene was asked. A source in the same state as at the first gives the same forces, bit for bit.
  template <class Visit>
  void replay(ForceSource& source, Visit visit) const {
    for (std::size_t i = 0; i < size(); ++i) {
      const RecordedTick& tick = m_ticks[i];
      if (!tick.hasSource) continue;
      ForceOut felt;
      felt.proxy = tick.tip.position;
      source.tick(tick.tip, felt);
      visit(tick, static_cast<const ForceOut&>(felt));
    }
  }

 private:
  PagedArray<RecordedTick> m_ticks;
  std::vector<RecordedEvent> m_events;
  std::uint64_t m_missing = 0;
};

}  // namespace handwheel
