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

// What is measured of a turned part.
struct PartMeasurement {
  std::vector<ProfileFeature> features;
  std::vector<ProfileFeature> wanted = {};   // of the target
  std::optional<TargetDeviation> deviation;  // none without a target
  double zero = 0.0;                         // mm, Z that places are shown from: that of drawing, programs and read-out
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
  // The scale of the colours in the view, and what its ends mean; none while they are not shown.
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

// A dimension in a few signs: "⌀ 40 mm · Z 0 mm … 30 mm"; Z from zero, mm.
QString dimensionText(const ProfileFeature& feature, double zero, LengthUnit unit, const QLocale& locale);

}  // namespace handwheel
