// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace handwheel {

// Scrolls a panel where the window has little room. It asks for the usual size of the panel and can do with a small
// one, so that panels do not make the smallest size of the window larger than screens are.
class ScrolledPanel : public QScrollArea {
  Q_OBJECT

 public:
  // Which ways it scrolls; across the other the panel keeps its smallest size.
  enum class Ways { Vertical, Both };

  // Takes the panel over.
  ScrolledPanel(QWidget* panel, Ways ways, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;

  Ways m_ways;
};

}  // namespace handwheel
