// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"
#include "haptics/device/PoseTrajectory.h"

#include <QStringList>
#include <QWidget>
#include <vector>

namespace handwheel {

// A widget that shows the live position of a device. Each measured axis has a bar that starts in the middle of its
// range, and its value. If the hand at the device is simulated, the user moves it with a knob on each bar, by mouse or
// arrow keys.
class AxisBars : public QWidget {
  Q_OBJECT

 public:
  explicit AxisBars(QWidget* parent = nullptr);

  // Sets the axes and their ranges.
  void setDevice(const DeviceCapabilities& device);
  void showState(const DeviceState& state);

  // Sets the meanings of the device axes in the document, X first, such as "radius (X)" on a lathe. An empty or missing
  // word means that the axis has no special meaning.
  void setWords(const QStringList& words);

  // Sets whether the user can move the simulated hand with this widget.
  void setLed(bool isLed);
  // Sets the target of the hand, which the knobs show.
  void showHand(const HandPose& hand);

  // Return the displayed and accessible text: "X 12.5 mm", "X 12.5 mm, Y …".
  QString text(std::size_t axis) const;
  QString text() const;
  std::size_t axes() const { return m_axes.size(); }
  double share(std::size_t axis) const;  // position within the range, -1 to 1; 0 for NaN

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

  // Returns the rectangle of the bar of an axis, which extends over its whole range.
  QRectF barRect(std::size_t axis) const;

 signals:
  // Emitted when the user moves the hand. Only its position and orientation have changed.
  void handLed(const handwheel::HandPose& hand);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Axis {
    QString name;
    QString unit;
    double reach = 1.0;
    double value = 0.0;
    double wanted = 0.0;  // target of the hand
  };
  int rowHeight() const;
  QString number(const Axis& axis) const;
  QString shownName(std::size_t axis) const;  // "Z radius (X)"
  void lead(double x);
  void leadTo(double value);

  std::vector<Axis> m_axes;
  QStringList m_words;
  HandPose m_hand;
  std::size_t m_chosen = 0;  // axis that the mouse and the keys move
  bool m_isLed = false;
  bool m_isDragged = false;
};

}  // namespace handwheel
