// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"

#include <QString>
#include <QWidget>
#include <vector>

namespace handwheel {

// Where a device is, live: a bar from the middle for each axis that it measures, with the number.
class AxisBars : public QWidget {
  Q_OBJECT

 public:
  explicit AxisBars(QWidget* parent = nullptr);

  // Which axes there are, and how far they go.
  void setDevice(const DeviceCapabilities& device);
  void showState(const DeviceState& state);

  // As it is shown and spoken: "X 12.5 mm", "X 12.5 mm, Y …".
  QString text(std::size_t axis) const;
  QString text() const;
  std::size_t axes() const { return m_axes.size(); }
  double share(std::size_t axis) const;  // of the reach, -1 to 1; 0 for what is no number

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
