// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

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
  double zero = 0.0;                         // mm, zero of displayed Z, as in drawings, programs and the read-out
};

// The panel with a part's dimensions, its deviation from the target, and the colour legend. The dimensions are measured
// on the part; the legend explains the colours in the view.
class TargetPanel : public QWidget {
  Q_OBJECT

 public:
  // actions: the actions that the panel shows as buttons.
  TargetPanel(const QList<QAction*>& actions, QWidget* parent = nullptr);

  // Shows measurements. target: the name of the target; empty: no target.
  void show(const PartMeasurement& measurement, const QString& target, LengthUnit unit);
  // Shows the scale of the colours in the view and a text on its ends. Without a scale, the legend is hidden.
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

// Returns a dimension in short form, such as "⌀ 40 mm · Z 0 mm … 30 mm". Z counts from `zero`, mm.
QString dimensionText(const ProfileFeature& feature, double zero, LengthUnit unit, const QLocale& locale);

}  // namespace handwheel
