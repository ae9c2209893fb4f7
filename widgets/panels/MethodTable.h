// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HoleFilling.h"
#include "mesh/PatchFigures.h"

#include <QTreeWidget>

namespace handwheel {

// What one method makes of a hole.
struct MethodTrial {
  FillMethod method = FillMethod::Fair;
  FillFailure failure = FillFailure::None;
  PatchFigures figures;  // where it did not fail
  double milliseconds = 0.0;
};

// The methods for one hole side by side. A click on a row chooses its method.
class MethodTable : public QTreeWidget {
  Q_OBJECT

 public:
  explicit MethodTable(QWidget* parent = nullptr);

  void showTrials(const std::vector<MethodTrial>& trials);
  void showChosen(FillMethod method);

 signals:
  void methodChosen(handwheel::FillMethod method);
};

}  // namespace handwheel
