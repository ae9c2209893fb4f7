// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "panels/time/TimeLine.h"

namespace handwheel {

// The track of a time line, with a lane and the markers of each recording. Dragging moves the position; a click on a
// marker goes to this marker. The arrow keys move the position by a step (Shift: ten, Ctrl: a tenth), Page Up and Page
// Down to the previous and the next marker, and Home and End to the ends.
class TimeTrack : public QWidget {
  Q_OBJECT

 public:
  // A displayed marker. The positions of markers and the lengths of lanes are in units of the axis.
  struct Marker {
    double position = 0.0;
    QString label;
    TimeLineMarker::Severity severity = TimeLineMarker::Severity::Note;
  };
  struct Lane {
    QString name;
    double length = 0.0;
    std::vector<Marker> markers;  // in ascending order of position
  };
  // The functions that convert between positions and pixels. They must agree with the plot above the track.
  struct Mapping {
    std::function<double(double)> screenX;
    std::function<double(double)> positionAt;
  };

  explicit TimeTrack(Mapping mapping, QWidget* parent = nullptr);

  void setLanes(std::vector<Lane> lanes);
  void setPosition(double position, const QString& text);  // text: accessible description of the position

  // Returns the position of the nearest marker of any lane after the present position, or before it.
  std::optional<double> nextMarker(bool backwards) const;
  // Return the marker at the present position, or at a pixel; null: none.
  const Marker* markerHere() const;
  const Marker* markerAt(const QPointF& pixel) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void positionWanted(double position);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  int laneHeight() const;
  QRectF bar(std::size_t lane) const;
  double length() const;
  double step() const;

  Mapping m_mapping;
  std::vector<Lane> m_lanes;
  double m_position = 0.0;
};

// Returns the colour of events of a severity, which is the same everywhere in the window.
QColor markerColour(TimeLineMarker::Severity severity);

}  // namespace handwheel
