// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // before <numbers> of Units.h, which moc cannot read alone

#include "base/Units.h"
#include "machining/target/ProfileFeatures.h"
#include "machining/target/TargetDeviation.h"
#include "viewport/overlay/ColourScale.h"

#include <QLocale>
#include <QWidget>
#include <optional>
#include <vector>

class QAction;
class QLabel;
class QListWidget;

namespace handwheel {

// Measurements of a turned part.
struct PartMeasurement {
  std::vector<ProfileFeature> features;
  std::vector<ProfileFeature> wanted = {};   // dimensions of the target
  std::optional<TargetDeviation> deviation;  // none without a target
  double zero = 0.0;                         // mm, zero of displayed Z: that of drawing, programs and read-out
};

// The panel with a part's dimensions, its deviation from the target and the colour legend. The dimensions are measured;
// the legend is that of the deviation's colours.
class TargetPanel : public QWidget {
  Q_OBJECT

 public:
  // actions: shown as buttons.
  TargetPanel(const QList<QAction*>& actions, QWidget* parent = nullptr);

  // target: its name; empty for none.
  void show(const PartMeasurement& measurement, const QString& target, LengthUnit unit);
  // Sets the scale of the colours in the view, and a text on its ends; none while colours are off.
  void setLegend(const std::optional<ColourScale>& scale, const QString& ends);
  static QString deviationLegend(double range, LengthUnit unit);  // range: mm

 private:
  QLabel* m_target;
  QLabel* m_wanted;
  QLabel* m_over;
  QLabel* m_under;
  QLabel* m_legend;
  QLabel* m_ends;
  QListWidget* m_dimensions;
};

// Returns a dimension in short form: "⌀ 40 mm · Z 0 mm … 30 mm"; Z from `zero`, mm.
QString dimensionText(const ProfileFeature& feature, double zero, LengthUnit unit, const QLocale& locale);

}  // namespace handwheel
