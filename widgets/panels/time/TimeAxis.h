// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/time/TimeLine.h"

#include <cstddef>

namespace handwheel {

// The axis on which recordings are compared: time, or the distance along their paths. A position on it is in s or mm.
// On the axis of distance, what two persons did at the same place of the part stands above each other, however fast
// they were. Window thread; a question costs O(log points).
class TimeAxis {
 public:
  enum class Kind { Time, Distance };

  void setRecordings(const std::vector<TimeLineRecording>& recordings);
  // Distance only where all recordings have one; else it stays time.
  void setKind(Kind kind) { m_kind = hasDistance() ? kind : Kind::Time; }
  Kind kind() const { return m_kind; }
  bool hasDistance() const;

  std::size_t recordings() const { return m_lanes.size(); }
  double duration(std::size_t recording) const { return m_lanes[recording].duration; }
  double length(std::size_t recording) const;  // of one
  double length() const;                       // of the longest; 0 without any

  // The first time at which a recording is at a position, within its duration; and back.
  double timeAt(std::size_t recording, double position) const;
  double positionAt(std::size_t recording, double time) const;

 private:
  struct Lane {
    double duration = 0.0;
    std::vector<QPointF> distance;
  };
  std::vector<Lane> m_lanes;
  Kind m_kind = Kind::Time;
};

// At most so many points of a curve, peaks and dips among them: what a picture of that width can show. Points that are
// not finite are left out. O(points).
std::vector<QPointF> thinnedCurve(const std::vector<QPointF>& points, std::size_t most);

}  // namespace handwheel
