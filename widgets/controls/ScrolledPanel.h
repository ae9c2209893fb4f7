// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace handwheel {

// A scroll area that scrolls a panel if the window has little room. Its size hint is that of the panel, but its minimum
// size is small, so that panels do not make the minimum size of the window larger than a screen.
class ScrolledPanel : public QScrollArea {
  Q_OBJECT

 public:
  // Scroll directions. In a direction without scrolling, the panel is never smaller than its minimum size.
  enum class Directions { Vertical, Both };

  // Creates the scroll area, which takes ownership of the panel.
  ScrolledPanel(QWidget* panel, Directions directions, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;

  Directions m_directions;
};

}  // namespace handwheel
