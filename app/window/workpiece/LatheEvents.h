// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/workpiece/ManualLatheTool.h"

#include <QListWidget>

namespace handwheel {

// Returns a translated sentence about a broken rule of cutting, with value and limit.
QString textOfRule(const CutWarning& warning);

// The log of a manual lathe's crashes and cut warnings, in chronological order. It must be used on the window thread.
class LatheEvents : public QListWidget {
  Q_OBJECT

 public:
  explicit LatheEvents(QWidget* parent = nullptr);

  void show(const ManualLatheTool& tool);

 private:
  std::vector<LatheCollision> m_crashes;
  std::vector<LatheWarning> m_warnings;
  double m_zero = 0.0;  // mm, zero of Z in the log
};

}  // namespace handwheel
