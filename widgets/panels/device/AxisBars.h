// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"
#include "haptics/device/PoseTrajectory.h"

#include <QStringList>
#include <QWidget>
#include <vector>

namespace handwheel {

// Shows the live position of a device. Each measured axis has a bar from the middle and its value. If the hand at the
// device is simulated, a knob on each bar moves it, by the mouse or with arrow keys.
class AxisBars : public QWidget {
  Q_OBJECT

 public:
  explicit AxisBars(QWidget* parent = nullptr);

  // Sets the axes and their ranges.
  void setDevice(const DeviceCapabilities& device);
  void showState(const DeviceState& state);

  // Sets the meanings of the axes in the work, X first; empty and missing words: unknown.
  void setWords(const QStringList& words);

  // Sets whether the user moves the simulated hand here.
  void setLed(bool isLed);
  // Sets the target of the hand, which the knobs show.
  void showHand(const HandPose& hand);

  // Return the displayed and accessible text: "X 12.5 mm", "X 12.5 mm, Y …".
  QString text(std::size_t axis) const;
  QString text() const;
  std::size_t axes() const { return m_axes.size(); }
  double share(std::size_t axis) const;  // share of the range, -1 to 1; 0 for NaN

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

  // Returns the bar of an axis, from one end of its range to the other.
  QRectF barRect(std::size_t axis) const;

 signals:
  void handLed(const handwheel::HandPose& hand);  // only its position and orientation differ

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
  std::size_t m_chosen = 0;  // axis that mouse and keys move
  bool m_isLed = false;
  bool m_isDragged = false;
};

}  // namespace handwheel
