// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace handwheel {

// Scrolls a panel if the window has little room. It asks for the usual size of the panel and can do with a small one,
// so that panels do not make the smallest size of the window larger than screens are.
class ScrolledPanel : public QScrollArea {
  Q_OBJECT

 public:
  // Scroll directions. Across a direction without scrolling the panel keeps its smallest size.
  enum class Directions { Vertical, Both };

  // Takes ownership of the panel.
  ScrolledPanel(QWidget* panel, Directions directions, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;

  Directions m_directions;
};

}  // namespace handwheel
