// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>
#include <QWidget>

namespace handwheel {

// The page of a ScrolledPanel with lists or plots. They take the room that there is, and it is scrolled only where they
// would become smaller than their least size. Of another page with wrapped lines the usual height is scrolled.
class SqueezedPage : public QWidget {
 public:
  using QWidget::QWidget;

  int heightForWidth(int width) const override { return layout() ? layout()->minimumHeightForWidth(width) : -1; }
};

}  // namespace handwheel
