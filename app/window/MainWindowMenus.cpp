// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The menus and tool bars of the main window.
#include "controls/ActionText.h"
#include "controls/CommandPalette.h"
#include "panels/DocumentsPanel.h"
#include "theme/Icons.h"
#include "tools/UnfinishedGesture.h"
#include "window/ActionToolTip.h"
#include "window/HelpPages.h"
#include "window/MainWindow.h"
#include "window/PanelToggle.h"
#include "window/ViewActions.h"
#include "window/ViewSettings.h"
#include "window/tools/ToolChoice.h"
#include "window/tools/ToolHost.h"

#include <QDockWidget>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace handwheel {

namespace {

constexpr QSize kToolIcon(20, 20);

QToolBar* addBar(MainWindow& window, Qt::ToolBarArea area, const char* name, const QString& title) {
  auto* bar = new QToolBar(title, &window);
  bar->setObjectName(QString::fromLatin1(name));
  bar->setMovable(false);
  bar->setFloatable(false);
  bar->setIconSize(kToolIcon);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  window.addToolBar(area, bar);
  return bar;
}

}  // namespace

void MainWindow::buildMenus() {
  m_showPanel.setObjectName(QStringLiteral("showPanel"));
  m_showPanel.setToolTip(tr("Show the whole model and its panel"));
  connect(&m_showPanel, &QAction::triggered, this, &MainWindow::showPanel);
  m_quit.setObjectName(QStringLiteral("quit"));
  m_quit.setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Q));
  m_quit.setMenuRole(QAction::QuitRole);
  connect(&m_quit, &QAction::triggered, this, &QWidget::close);
  QMenu* file = menuBar()->addMenu(tr("&File"));
  file->addAction(m_fileActions.open());
  file->addMenu(m_fileActions.recentMenu());
  file->addMenu(tr("&New"))->addActions(m_fileActions.newActions());
  file->addMenu(tr("Sa&mples and exercises"))->addActions(m_fileActions.sampleActions());
  file->addSeparator();
  file->addActions({m_fileActions.save(), m_fileActions.saveAs()});
  file->addActions(m_copies.actions());
  file->addSeparator();
  file->addActions({m_fileActions.closeTab(), &m_quit});

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = m_undo.createUndoAction(this, tr("&Undo"));
  QAction* redo = m_undo.createRedoAction(this, tr("&Redo"));
  undo->setObjectName(QStringLiteral("undo"));
  redo->setObjectName(QStringLiteral("redo"));
  // In a live gesture it is the gesture that is undone, not the step before it: the tool knows.
  undo->disconnect(&m_undo);
  connect(undo, &QAction::triggered, this, [this] {
    if (m_tools->runner().undo() == ToolReply::Ignored) m_undo.undo();
  });
  const auto enableUndo = [this, undo] {
    const Tool* const tool = m_tools->runner().tool();
    undo->setEnabled(m_undo.canUndo() || (tool && tool->isLive()));
    const auto* const work = dynamic_cast<const UnfinishedGesture*>(tool);
    const QString underWay = work ? work->underWay() : QString(),
                  step = underWay.isEmpty() ? m_undo.undoText() : underWay;
    undo->setText(step.isEmpty() ? tr("&Undo") : tr("&Undo %1").arg(step));
  };
  connect(&m_undo, &QUndoGroup::canUndoChanged, undo, enableUndo);
  connect(&m_undo, &QUndoGroup::undoTextChanged, undo, enableUndo);
  connect(m_tools, &ToolHost::updated, undo, enableUndo);
  // An unfinished gesture makes a step of its own, and nothing can be redone after that.
  const auto enableRedo = [this, redo] {
    const auto* const work = dynamic_cast<const UnfinishedGesture*>(m_tools->runner().tool());
    redo->setEnabled(m_undo.canRedo() && (!work || work->underWay().isEmpty()));
  };
  connect(&m_undo, &QUndoGroup::canRedoChanged, redo, enableRedo);
  connect(m_tools, &ToolHost::updated, redo, enableRedo);
  undo->setIcon(icon(QStringLiteral("undo")));
  redo->setIcon(icon(QStringLiteral("redo")));
  undo->setShortcut(QKeySequence::Undo);
  redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  edit->addActions({undo, redo});
  edit->addSeparator();
  QAction* preferences = edit->addAction(tr("&Preferences…"), this, &MainWindow::showPreferences);
  preferences->setObjectName(QStringLiteral("preferences"));
  QAction* calibrate = edit->addAction(tr("&Measure this machine"), &m_calibrator, &BenchmarkRunner::start);
  calibrate->setObjectName(QStringLiteral("calibrate"));
  setActionToolTip(*calibrate,
                   tr("Measure how fast each setting of the panel “Fidelity” is on this machine: about half a minute"));
  preferences->setMenuRole(QAction::PreferencesRole);
  setActionToolTip(*preferences, tr("Keyboard shortcuts, mouse, units, language, autosave"));

  QMenu* view = menuBar()->addMenu(tr("&View"));
  view->setObjectName(QStringLiteral("viewMenu"));
  view->addAction(m_viewActions->fit());
  view->addSeparator();
  view->addActions(m_viewActions->views());
  view->addSeparator();
  view->addActions(m_viewActions->shadings());
  view->addSeparator();
  view->addActions(m_viewSettings->viewActions());
  view->addAction(m_viewSettings->clipAction());
  view->addAction(m_viewSettings->halfSectionAction());
  view->addAction(m_documents->visibilityAction());
  view->addSeparator();
  for (QDockWidget* dock : docks()) view->addAction(dock->findChild<PanelToggle*>());
  view->addSeparator();
  view->addActions(m_fileActions.tabSteps());
  view->addSeparator();
  view->addAction(m_viewActions->darkTheme());

  QMenu* device = menuBar()->addMenu(tr("&Device"));
  device->addAction(findChild<QAction*>(QStringLiteral("snapDevice")));
  device->addSeparator();
  device->addAction(m_recordings.recordAction());
  device->addSeparator();
  device->addActions({m_recordings.playAction(), m_recordings.leaveAction(), m_recordings.exportAction(),
                      m_recordings.renameAction(), m_recordings.removeAction()});

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  help->setObjectName(QStringLiteral("helpMenu"));
  m_palette = new CommandPalette(this);
  help->addAction(m_palette->action());
  QAction* keys =
      help->addAction(tr("&Keys and mouse"), QKeySequence(Qt::Key_F1), this, [this] { showKeys(*this, hints()); });
  keys->setObjectName(QStringLiteral("showKeys"));
  QAction* about = help->addAction(tr("&About Handwheel"), this, [this] { showAbout(*this); });
  about->setObjectName(QStringLiteral("about"));
}

void MainWindow::buildToolBars() {
  QToolBar* quick = addBar(*this, Qt::TopToolBarArea, "quickActions", tr("Quick actions"));
  quick->addActions({m_fileActions.open(), m_fileActions.save()});
  quick->addSeparator();
  quick->addActions({findChild<QAction*>(QStringLiteral("undo")), findChild<QAction*>(QStringLiteral("redo"))});
  quick->addSeparator();
  quick->addActions(m_viewActions->shadings());
  quick->addSeparator();
  quick->addAction(m_viewActions->fit());
  quick->addActions(m_viewActions->views().mid(0, 2) +
                    QList<QAction*>{m_viewActions->views().at(3), m_viewActions->views().at(5)});
  quick->addAction(m_viewActions->darkTheme());
  nameButtons(*quick);
  m_kindBar = addBar(*this, Qt::TopToolBarArea, "kindActions", tr("Actions of the document"));

  QToolBar* strip = addBar(*this, Qt::LeftToolBarArea, "panelStrip", tr("Panels"));
  for (QDockWidget* dock : docks()) strip->addAction(dock->findChild<PanelToggle*>());
  nameButtons(*strip);
}

void MainWindow::placeKinds() {
  m_kindMenus = std::make_unique<KindMenus>(*m_kindDock, *m_kindPanels, *m_kindBar);
  auto* help = findChild<QMenu*>(QStringLiteral("helpMenu"));
  for (const auto& [id, kind] : m_uis) m_kindMenus->add(id, *kind, m_toolChoice->actions(*kind), *menuBar(), *help);
  for (const auto& [id, kind] : m_uis) help->insertActions(help->actions().first(), kind->help());
  // The panels that kinds of documents have made, below those of the window.
  auto* view = findChild<QMenu*>(QStringLiteral("viewMenu"));
  const QList<QAction*> entries = view->actions();
  QAction* const below = entries.value(entries.indexOf(docks().last()->findChild<PanelToggle*>()) + 1);
  for (QDockWidget* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    auto* const toggle = docks().contains(dock) ? nullptr : dock->findChild<PanelToggle*>();
    if (toggle) view->insertAction(below, toggle);
  }
}

// At the end of the menu bar, where it takes no room from the view.
void MainWindow::addSearch() {
  QAction* action = m_palette->action();
  action->setIconText(withoutMnemonic(action->text()));
  auto* search = new QToolButton(this);
  search->setObjectName(QStringLiteral("searchButton"));
  search->setDefaultAction(action);
  search->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  search->setIconSize({16, 16});
  search->setAccessibleName(tr("Search commands"));
  menuBar()->setCornerWidget(search);
}

}  // namespace handwheel
