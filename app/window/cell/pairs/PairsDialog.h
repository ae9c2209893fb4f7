// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PairNames.h"

#include <QDialog>

class QListWidget;

namespace handwheel {

// A dialog that asks which pairs of links and bodies may touch. It lists the pairs that may touch already, and those
// that were found to collide.
class PairsDialog : public QDialog {
  Q_OBJECT

 public:
  // found: pairs that collide or are too close, and may not touch.
  PairsDialog(const CellPlans& plans, const std::set<PairNames>& found, const BodySet& bodies, QWidget* parent);

 signals:
  // allowed: pairs that may touch from now on; forbidden: those that no longer may. At least one of them is not empty.
  void chosen(const std::vector<handwheel::PairNames>& allowed, const std::vector<handwheel::PairNames>& forbidden);

 private:
  void add(const PairNames& pair, const BodySet& bodies, bool isAllowed);
  void accept() override;

  std::vector<std::pair<PairNames, bool>> m_pairs;  // Pair of each row, and true if it was allowed before
  QListWidget* m_list;
};

}  // namespace handwheel
