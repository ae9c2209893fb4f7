// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "mesh/holes/PatchStatistics.h"

#include <QTreeWidget>

namespace handwheel {

// The result of one fill method on a hole.
struct MethodTrial {
  FillMethod method = FillMethod::Fair;
  FillFailure failure = FillFailure::None;
  PatchStatistics statistics;  // valid if the method did not fail
  double milliseconds = 0.0;
};

// A table that compares the fill methods for one hole. A click on a row chooses its method.
class MethodTable : public QTreeWidget {
  Q_OBJECT

 public:
  explicit MethodTable(QWidget* parent = nullptr);

  void showTrials(const std::vector<MethodTrial>& trials);
  void showChosen(FillMethod method);
  QSize sizeHint() const override;

 signals:
  void methodChosen(handwheel::FillMethod method);
};

}  // namespace handwheel
