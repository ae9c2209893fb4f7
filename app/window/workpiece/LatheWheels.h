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

// The handwheels of a manual lathe. When a wheel is turned clockwise, the carriage moves away from the chuck, the cross
// slide and the compound slide move in, and the quill comes out, as on a usual engine lathe. The dials count clockwise.
// It must be used on the window thread.
class LatheWheels : public QWidget {
  Q_OBJECT

 public:
  explicit LatheWheels(QWidget* parent = nullptr);

  void show(const ManualLatheTool& tool);
  // Positions of the rings of the dials: the travel of each slide at which its dial shows zero, mm.
  using Rings = std::array<double, kLatheAxes>;
  Rings rings() const;
  // Sets the rings without a signal. If `rings` is none, the dials show zero at the present travel of the slides.
  void setRings(const ManualLatheTool& tool, const std::optional<Rings>& rings);

 signals:
  void turned(handwheel::LatheAxis axis, double mm);  // mm: travel of the slide

 private:
  void countOnDiameter(bool isDiameter);

  std::array<HandwheelDial*, kLatheAxes> m_dials{};
  std::array<QLabel*, kLatheAxes> m_captions{};
  std::array<double, kLatheAxes> m_turned{};                    // mm, travel of the slides
  std::array<double, kLatheAxes> m_scales{1.0, 1.0, 1.0, 1.0};  // dial values divided by travel
};

}  // namespace handwheel
