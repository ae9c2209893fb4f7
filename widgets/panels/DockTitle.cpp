// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/DockTitle.h"

#include "theme/Icons.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace handwheel {

DockTitle::DockTitle(QDockWidget* dock) : QFrame(dock) {
  setObjectName(QStringLiteral("dockTitle"));
  auto* text = new QLabel(dock->windowTitle(), this);
  text->setObjectName(QStringLiteral("dockTitleText"));
  auto* fold = new QToolButton(this);
  fold->setObjectName(dock->objectName() + QStringLiteral("FoldButton"));
  fold->setIcon(icon(QStringLiteral("close")));
  fold->setIconSize({12, 12});
  fold->setAutoRaise(true);
  fold->setToolTip(tr("Fold this panel away"));
  fold->setAccessibleName(tr("Fold the panel “%1” away").arg(dock->windowTitle()));
  connect(fold, &QToolButton::clicked, dock, &QDockWidget::close);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 2, 4, 2);
  row->addWidget(text, 1);
  row->addWidget(fold);
}

}  // namespace handwheel
