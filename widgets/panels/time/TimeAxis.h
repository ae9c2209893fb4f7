// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/time/TimeLine.h"

#include <cstddef>

namespace handwheel {

// The axis on which recordings are compared: time, or the distance along their paths. A position on it is in s or mm.
// On the axis of distance, values of two recordings at the same position of the part are drawn above each other,
// independently of the speeds. An axis is used on the window thread; a query costs O(log points).
class TimeAxis {
 public:
  enum class Kind { Time, Distance };

  void setRecordings(const std::vector<TimeLineRecording>& recordings);
  // Sets the kind. It remains Kind::Time unless all recordings have a distance along their paths.
  void setKind(Kind kind) { m_kind = hasDistance() ? kind : Kind::Time; }
  Kind kind() const { return m_kind; }
  bool hasDistance() const;

  std::size_t recordings() const { return m_lanes.size(); }
  double duration(std::size_t recording) const { return m_lanes[recording].duration; }
  double length(std::size_t recording) const;  // length of one recording
  double length() const;                       // length of the longest one; 0 if there is none

  // Convert between a position and the first time at which a recording is there, within its duration.
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

// Thins a curve to at most `most` points, which include its peaks and dips. They suffice for a picture that is as many
// pixels wide. Points that are not finite are left out. O(points).
std::vector<QPointF> thinnedCurve(const std::vector<QPointF>& points, std::size_t most);

}  // namespace handwheel
