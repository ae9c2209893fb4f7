// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/SqueezedPage.h"
#include "plot/Plot.h"

class QLabel;
class QSlider;
class QVBoxLayout;

namespace handwheel {

class FidelityChoice;
class PlotWidget;
class PropertyList;

// The panel that shows and edits the accuracy settings. It lists the preset and each setting. For the setting that has
// the focus, or had it last, the panel shows a slider, the predicted error and cost, the presets, and the measured
// curve with the present value. The prediction and the curve follow the slider while it is dragged; the value is
// applied when the slider is released.
class FidelityPanel : public SqueezedPage {
  Q_OBJECT

 public:
  explicit FidelityPanel(FidelityChoice& choice, QWidget* parent = nullptr);

  // Adds a widget below everything else.
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
  QLabel* m_fit;    // the limits of the preset Fit
  QLabel* m_title;  // title of the setting that the slider edits
  QSlider* m_slider;
  QLabel* m_prediction;
  PlotWidget* m_curve;
  QVBoxLayout* m_below;
  std::string m_shown;  // id of the setting that the slider edits
};

}  // namespace handwheel
