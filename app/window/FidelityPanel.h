// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plot/Plot.h"

#include <QWidget>

class QLabel;
class QSlider;
class QVBoxLayout;

namespace handwheel {

class FidelityChoice;
class PlotWidget;
class PropertyList;

// Shows where the user stands between speed and accuracy: preset, each setting, and of the one that has the focus, or
// had it last, a slider on its own scale, what its value is predicted to err and cost, its presets, and the measured
// curve with the value on it. While the slider is held all of that follows it; the choice is made when it is let go.
class FidelityPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FidelityPanel(FidelityChoice& choice, QWidget* parent = nullptr);

  // Below everything else.
  void addBelow(QWidget* widget);

 private:
  void follow(QWidget* focused);
  void showSetting(const std::string& id);
  void edit(const std::string& id, double value);
  void refresh();
  void predict(double value);
  Plot plotOf(const std::string& id, double value) const;

  FidelityChoice& m_choice;
  PropertyList* m_list;
  QLabel* m_fit;    // what Fit keeps to
  QLabel* m_title;  // of what is below
  QSlider* m_slider;
  QLabel* m_prediction;
  PlotWidget* m_curve;
  QVBoxLayout* m_below;
  std::string m_shown;  // id of the setting
};

}  // namespace handwheel
