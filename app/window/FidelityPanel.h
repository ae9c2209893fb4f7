// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plot/Plot.h"

#include <QWidget>

class QLabel;

namespace handwheel {

class FidelityChoice;
class PropertyList;

// Shows where the user stands between speed and accuracy: preset, each setting, and the measured curve of the one that
// was touched last, with the present choice on it.
class FidelityPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FidelityPanel(FidelityChoice& choice, QWidget* parent = nullptr);

 private:
  class Curve;
  void edit(const std::string& id, double value);
  void refresh();
  Plot plotOf(const std::string& id) const;

  FidelityChoice& m_choice;
  PropertyList* m_list;
  QLabel* m_title;  // of the curve
  Curve* m_curve;
  std::string m_shown;  // id of the setting whose curve is drawn
};

}  // namespace handwheel
