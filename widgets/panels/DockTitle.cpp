// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/DockTitle.h"

#include "theme/Icons.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace handwheel {

namespace {

QToolButton* button(const QString& name, QWidget* parent) {
  auto* result = new QToolButton(parent);
  result->setObjectName(name);
  result->setIconSize({14, 14});
  result->setAutoRaise(true);
  result->setFocusPolicy(Qt::TabFocus);
  return result;
}

}  // namespace

DockTitle::DockTitle(QDockWidget* dock)
    : QFrame(dock),
      m_dock(dock),
      m_float(button(dock->objectName() + QStringLiteral("FloatButton"), this)),
      m_fold(button(dock->objectName() + QStringLiteral("FoldButton"), this)) {
  setObjectName(QStringLiteral("dockTitle"));
  auto* text = new QLabel(dock->windowTitle(), this);
  text->setObjectName(QStringLiteral("dockTitleText"));
  m_fold->setIcon(icon(QStringLiteral("close")));
  connect(dock, &QDockWidget::windowTitleChanged, text, &QLabel::setText);
  connect(dock, &QDockWidget::windowTitleChanged, this, &DockTitle::showState);
  connect(dock, &QDockWidget::topLevelChanged, this, &DockTitle::showState);
  connect(dock, &QDockWidget::featuresChanged, this, &DockTitle::showState);
  connect(m_float, &QToolButton::clicked, dock, [dock] { dock->setFloating(!dock->isFloating()); });
  connect(m_fold, &QToolButton::clicked, dock, &QDockWidget::close);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 2, 4, 2);
  row->setSpacing(0);
  row->addWidget(text, 1);
  row->addWidget(m_float);
  row->addWidget(m_fold);
  showState();
}

void DockTitle::showState() {
  const QString name = m_dock->windowTitle();
  const bool floats = m_dock->isFloating();
  m_float->setVisible(m_dock->features() & QDockWidget::DockWidgetFloatable);
  m_fold->setVisible(m_dock->features() & QDockWidget::DockWidgetClosable);
  m_float->setIcon(icon(floats ? QStringLiteral("dock") : QStringLiteral("float")));
  m_float->setToolTip(floats ? tr("Dock this panel") : tr("Undock this panel"));
  m_float->setAccessibleName(floats ? tr("Dock the panel “%1”").arg(name) : tr("Undock the panel “%1”").arg(name));
  m_fold->setToolTip(tr("Hide this panel"));
  m_fold->setAccessibleName(tr("Hide the panel “%1”").arg(name));
}

}  // namespace handwheel
