// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <QString>
#include <QWidget>
#include <vector>

namespace handwheel {

// Shows the live position of a device. Each measured axis has a bar from the middle and its value.
class AxisBars : public QWidget {
  Q_OBJECT

 public:
  explicit AxisBars(QWidget* parent = nullptr);

  // Sets the axes and their ranges.
  void setDevice(const DeviceCapabilities& device);
  void showState(const DeviceState& state);

  // The displayed and accessible text: "X 12.5 mm", "X 12.5 mm, Y …".
  QString text(std::size_t axis) const;
  QString text() const;
  std::size_t axes() const { return m_axes.size(); }
  double share(std::size_t axis) const;  // of the range, -1 to 1; 0 for NaN

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Axis {
    QString name;
    QString unit;
    double reach = 1.0;
    double value = 0.0;
  };
  int rowHeight() const;
  QString number(const Axis& axis) const;

  std::vector<Axis> m_axes;
};

}  // namespace handwheel
