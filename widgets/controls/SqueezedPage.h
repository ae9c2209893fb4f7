// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>
#include <QWidget>

namespace handwheel {

// The page of a ScrolledPanel with lists or plots. The lists or plots fill the available room, and the page is scrolled
// only if they would become smaller than their minimum size. Without this class, a page with wrapped lines gets the
// height of its size hint, and is scrolled even if there is room.
class SqueezedPage : public QWidget {
 public:
  using QWidget::QWidget;

  int heightForWidth(int width) const override { return layout() ? layout()->minimumHeightForWidth(width) : -1; }
};

}  // namespace handwheel
