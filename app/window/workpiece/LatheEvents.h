// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/workpiece/ManualLatheTool.h"

#include <QListWidget>

namespace handwheel {

// A rule that a cut breaks as a translated sentence, with the value and the limit.
QString textOfRule(const CutWarning& warning);

// The crashes of a manual lathe and the warnings of its cuts, in the order in which they came. Window thread.
class LatheEvents : public QListWidget {
  Q_OBJECT

 public:
  explicit LatheEvents(QWidget* parent = nullptr);

  void show(const ManualLatheTool& tool);

 private:
  std::vector<LatheCollision> m_crashes;
  std::vector<LatheWarning> m_warnings;
};

}  // namespace handwheel
