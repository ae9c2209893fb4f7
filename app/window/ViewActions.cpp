// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/ViewActions.h"

#include "theme/Icons.h"
#include "theme/Theme.h"
#include "viewport/Viewport.h"
#include "window/ActionToolTip.h"

#include <QApplication>
#include <QSettings>

namespace handwheel {

ViewActions::ViewActions(Viewport& viewport, QObject* parent)
    : QObject(parent),
      m_viewport(viewport),
      m_fit(tr("&Fit"), this),
      m_dark(tr("&Dark theme"), this),
      m_shadings(this) {
  m_fit.setObjectName(QStringLiteral("fitView"));
  m_fit.setIcon(icon(QStringLiteral("fit")));
  m_fit.setShortcut(QKeySequence(Qt::Key_F));
  setActionToolTip(m_fit, tr("Show the whole model"));
  connect(&m_fit, &QAction::triggered, this, [this] { m_viewport.fit(); });

  addView(StandardView::Isometric, tr("&Isometric"), Qt::Key_7, "view-iso", "viewIsometric");
  addView(StandardView::Front, tr("F&ront"), Qt::Key_1, "view-front", "viewFront");
  addView(StandardView::Back, tr("&Back"), Qt::Key_2, "view-front", "viewBack");
  addView(StandardView::Right, tr("Rig&ht"), Qt::Key_3, "view-right", "viewRight");
  addView(StandardView::Left, tr("&Left"), Qt::Key_4, "view-right", "viewLeft");
  addView(StandardView::Top, tr("&Top"), Qt::Key_5, "view-top", "viewTop");
  addView(StandardView::Bottom, tr("Botto&m"), Qt::Key_6, "view-top", "viewBottom");
  addView(StandardView::Lathe, tr("L&athe"), Qt::Key_8, "view-right", "viewLathe");

  addShading(Shading::Shaded, tr("&Shaded"), "shaded", "shaded");
  addShading(Shading::ShadedWithEdges, tr("Shaded with &edges"), "shaded-edges", "shadedWithEdges");
  addShading(Shading::Wireframe, tr("&Wireframe"), "wireframe", "wireframe");

  m_dark.setObjectName(QStringLiteral("darkTheme"));
  m_dark.setIcon(icon(QStringLiteral("theme")));
  m_dark.setCheckable(true);
  m_dark.setIconVisibleInMenu(false);  // the check mark stands there
  m_dark.setToolTip(tr("Switch between the light and the dark theme"));
  m_dark.setChecked(currentTheme() == ThemeKind::Dark);
  m_viewport.setDarkTheme(m_dark.isChecked());
  connect(&m_dark, &QAction::toggled, this, &ViewActions::useTheme);
}

QList<QAction*> ViewActions::views() const {
  return {m_views.begin(), m_views.end()};
}

void ViewActions::addView(StandardView view, const QString& text, int key, const char* iconName, const char* name) {
  auto* action = new QAction(icon(QString::fromLatin1(iconName)), text, this);
  action->setObjectName(QString::fromLatin1(name));
  action->setShortcut(QKeySequence(key));
  setActionToolTip(*action, tr("Look from: %1").arg(action->iconText()));
  connect(action, &QAction::triggered, this, [this, view] { m_viewport.setStandardView(view); });
  m_views.push_back(action);
}

void ViewActions::addShading(Shading shading, const QString& text, const char* iconName, const char* name) {
  auto* action = m_shadings.addAction(icon(QString::fromLatin1(iconName)), text);
  action->setObjectName(QString::fromLatin1(name));
  action->setCheckable(true);
  action->setIconVisibleInMenu(false);
  action->setChecked(m_viewport.shading() == shading);
  connect(action, &QAction::triggered, this, [this, shading] { m_viewport.setShading(shading); });
}

void ViewActions::useTheme(bool dark) {
  applyTheme(*qApp, dark ? ThemeKind::Dark : ThemeKind::Light);
  m_viewport.setDarkTheme(dark);
  QSettings().setValue(QStringLiteral("darkTheme"), dark);
}

}  // namespace handwheel
