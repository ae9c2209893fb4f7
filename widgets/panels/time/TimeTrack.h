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
// marker goes to it. Keys: arrows a step (Shift: ten, Ctrl: a tenth), Page Up and Down the markers, Home and End.
class TimeTrack : public QWidget {
  Q_OBJECT

 public:
  // The displayed markers and lanes, in units of the axis.
  struct Marker {
    double position = 0.0;
    QString label;
    TimeLineMarker::Severity severity = TimeLineMarker::Severity::Note;
  };
  struct Lane {
    QString name;
    double length = 0.0;
    std::vector<Marker> markers;  // ascending
  };
  // Conversion between a position and a pixel: the same as in the plot above.
  struct Mapping {
    std::function<double(double)> screenX;
    std::function<double(double)> positionAt;
  };

  explicit TimeTrack(Mapping mapping, QWidget* parent = nullptr);

  void setLanes(std::vector<Lane> lanes);
  void setPosition(double position, const QString& text);  // text: accessible description of the position

  // Returns the next marker of any lane behind or before the position.
  std::optional<double> nextMarker(bool backwards) const;
  // Return the marker at the position, or below a pixel.
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

// Returns the colour of an event, as everywhere in the window.
QColor markerColour(TimeLineMarker::Severity severity);

}  // namespace handwheel
