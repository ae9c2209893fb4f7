// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/workpiece/ManualLatheTool.h"

#include <QWidget>
#include <array>
#include <optional>

class QLabel;

namespace handwheel {

class HandwheelDial;

// The handwheels of a manual lathe. Turned clockwise, as on the usual engine lathe, the carriage goes away from the
// chuck, cross slide and compound slide go in, and the quill comes out; dials count clockwise. Window thread.
class LatheWheels : public QWidget {
  Q_OBJECT

 public:
  explicit LatheWheels(QWidget* parent = nullptr);

  void show(const ManualLatheTool& tool);
  // Where the rings of the dials stand: at which travel of its slide each shows zero, mm.
  using Rings = std::array<double, kLatheAxes>;
  Rings rings() const;
  // Sets the rings, without a signal; none: to zero where the slides are.
  void setRings(const ManualLatheTool& tool, const std::optional<Rings>& rings);

 signals:
  void turned(handwheel::LatheAxis axis, double mm);  // on by this way of its slide

 private:
  void countOnDiameter(bool isDiameter);

  std::array<HandwheelDial*, kLatheAxes> m_dials{};
  std::array<QLabel*, kLatheAxes> m_captions{};
  std::array<double, kLatheAxes> m_turned{};                    // mm of the slides
  std::array<double, kLatheAxes> m_scales{1.0, 1.0, 1.0, 1.0};  // of the dials, to that
};

}  // namespace handwheel
