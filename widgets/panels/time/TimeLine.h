// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QString>
#include <vector>

namespace handwheel {

// A value that was recorded over time, to be drawn above a time line. The structs of a time line are plain values; the
// texts come from the caller.
struct TimeLineCurve {
  QString name;                 // "Cutting force"; curves of the same name are drawn together
  QString unit;                 // "N"
  std::vector<QPointF> points;  // time (s) and value, times ascending
  QString label = {};           // text beside the line; empty: the name of the recording
};

// An event to which the user can jump.
struct TimeLineMarker {
  enum class Severity { Note, Warning, Error };
  double time = 0.0;  // s
  QString label;      // "Collision: tool holder with jaw"
  Severity severity = Severity::Note;
};

// A recording as a time line shows it.
struct TimeLineRecording {
  QString name;
  double duration = 0.0;  // s; a duration that is not finite or below zero counts as zero
  std::vector<TimeLineCurve> curves;
  std::vector<TimeLineMarker> markers;
  // Time (s) and distance along the path of the tool (mm), both ascending. It is empty if the distance is unknown.
  std::vector<QPointF> distance;
};

}  // namespace handwheel
