// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How the main window is put together: centre, docks, status bar, menus and tool bars.
#include "panels/ActionButton.h"
#include "panels/DefectsPanel.h"
#include "panels/DockTitle.h"
#include "panels/DocumentsPanel.h"
#include "panels/HintBar.h"
#include "panels/JobBar.h"
#include "panels/LogPanel.h"
#include "panels/MessageBar.h"
#include "panels/NextStepCard.h"
#include "panels/StartPage.h"
#include "theme/Icons.h"
#include "viewport/Viewport.h"
#include "window/DocumentScene.h"
#include "window/DocumentTabs.h"
#include "window/HelpPages.h"
#include "window/MainWindow.h"
#include "window/ViewActions.h"

#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoView>
#include <QVBoxLayout>

namespace handwheel {

namespace {

constexpr QSize kToolIcon(20, 20);

QDockWidget* addDock(MainWindow& window, Qt::DockWidgetArea area, const char* name, const QString& title,
                     QWidget* content, const char* iconName) {
  auto* dock = new QDockWidget(title, &window);
  dock->setObjectName(QString::fromLatin1(name));
  dock->setAccessibleName(title);
  dock->setWidget(content);
  dock->setTitleBarWidget(new DockTitle(dock));
  dock->toggleViewAction()->setIconVisibleInMenu(false);
  dock->toggleViewAction()->setIcon(icon(QString::fromLatin1(iconName)));
  dock->toggleViewAction()->setObjectName(dock->objectName() + QStringLiteral("Toggle"));
  window.addDockWidget(area, dock);
  return dock;
}

// Names the buttons of a tool bar after their actions, for screen readers and tests.
void nameButtons(QToolBar& bar) {
  for (QAction* action : bar.actions()) {
    auto* button = qobject_cast<QToolButton*>(bar.widgetForAction(action));
    if (!button || action->objectName().isEmpty()) continue;
    button->setObjectName(bar.objectName() + QLatin1Char('/') + action->objectName());
    button->setAccessibleName(action->iconText());
  }
}

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

void MainWindow::buildCentre() {
  auto* centre = new QWidget(this);
  m_messages = new MessageBar(centre);
  m_stack = new QStackedWidget(centre);
  m_start = new StartPage(m_stack);
  m_viewport = new Viewport(m_stack);
  m_viewport->setObjectName(QStringLiteral("viewport"));
  m_viewport->setAccessibleName(tr("3D view"));
  m_viewport->setFocusPolicy(Qt::StrongFocus);
  m_stack->addWidget(m_start);
  m_stack->addWidget(m_viewport);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(m_tabs);
  column->addWidget(m_messages);
  column->addWidget(m_stack, 1);
  setCentralWidget(centre);
  m_viewActions = new ViewActions(*m_viewport, this);
  m_card = new NextStepCard(m_viewport);
  connect(m_viewport, &Viewport::graphicsFailed, m_messages, [this](const QString& problem) {
    m_messages->showMessage({Message::Weight::Error,
                             tr("The 3D view cannot be drawn"),
                             problem,
                             tr("Files can still be repaired and saved."),
                             {},
                             {}});
  });
}

void MainWindow::buildDocks() {
  m_documents = new DocumentsPanel(this);
  auto* history = new QUndoView(&m_undo, this);
  history->setObjectName(QStringLiteral("historyView"));
  history->setAccessibleName(tr("History"));
  history->setEmptyLabel(tr("As opened"));
  m_defects = new DefectsPanel({m_repairActions.repairAll(), m_repairActions.previous(), m_repairActions.next(),
                                m_repairActions.fill(), m_repairActions.keepOpen(), m_repairActions.preview()},
                               this);
  m_defects->setMinimumWidth(264);
  m_documentsDock = addDock(*this, Qt::LeftDockWidgetArea, "documentsDock", tr("Documents"), m_documents, "documents");
  m_historyDock = addDock(*this, Qt::LeftDockWidgetArea, "historyDock", tr("History"), history, "history");
  m_defectsDock = addDock(*this, Qt::RightDockWidgetArea, "defectsDock", tr("Defects"), m_defects, "defects");
  m_logDock = addDock(*this, Qt::BottomDockWidgetArea, "logDock", tr("Log"), new LogPanel(&m_log, this), "log");
  connect(m_defectsDock, &QDockWidget::visibilityChanged, this, &MainWindow::updateCard);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  resizeDocks({m_documentsDock, m_defectsDock}, {216, 272}, Qt::Horizontal);
  resizeDocks({m_documentsDock, m_historyDock}, {300, 300}, Qt::Vertical);
  resizeDocks({m_logDock}, {176}, Qt::Vertical);
  m_scene = new DocumentScene(*m_viewport, m_selection, m_preview, *m_defects->model(), this);
}

void MainWindow::buildStatusBar() {
  m_hints = new HintBar(this);
  m_jobBar = new JobBar(this);
  m_figures = new QLabel(this);
  m_figures->setObjectName(QStringLiteral("triangleCount"));
  m_unit = new QLabel(tr("mm"), this);
  m_unit->setObjectName(QStringLiteral("badge"));
  m_unit->setToolTip(tr("Lengths are in millimetres, as in the file"));
  auto* log = new QToolButton(this);
  log->setObjectName(QStringLiteral("logButton"));
  log->setDefaultAction(m_logDock->toggleViewAction());
  log->setAccessibleName(tr("Log"));
  log->setIconSize({16, 16});
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(m_hints, 1);
  for (QWidget* widget : std::initializer_list<QWidget*>{m_jobBar, m_figures, m_unit, log}) {
    statusBar()->addPermanentWidget(widget);
  }
}

void MainWindow::buildMenus() {
  m_quit.setObjectName(QStringLiteral("quit"));
  m_quit.setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Q));
  m_quit.setMenuRole(QAction::QuitRole);
  connect(&m_quit, &QAction::triggered, this, &QWidget::close);
  QMenu* file = menuBar()->addMenu(tr("&File"));
  file->addAction(m_fileActions.open());
  file->addMenu(m_fileActions.recentMenu());
  file->addAction(m_fileActions.openSample());
  file->addSeparator();
  file->addActions({m_fileActions.save(), m_fileActions.saveAs()});
  file->addSeparator();
  file->addActions({m_fileActions.closeTab(), &m_quit});

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = m_undo.createUndoAction(this, tr("&Undo"));
  QAction* redo = m_undo.createRedoAction(this, tr("&Redo"));
  undo->setObjectName(QStringLiteral("undo"));
  redo->setObjectName(QStringLiteral("redo"));
  undo->setIcon(icon(QStringLiteral("undo")));
  redo->setIcon(icon(QStringLiteral("redo")));
  undo->setShortcut(QKeySequence::Undo);
  redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  edit->addActions({undo, redo});
  edit->addSeparator();
  edit->addAction(m_repairActions.deselect());

  QMenu* view = menuBar()->addMenu(tr("&View"));
  view->addAction(m_viewActions->fit());
  view->addSeparator();
  view->addActions(m_viewActions->views());
  view->addSeparator();
  view->addActions(m_viewActions->shadings());
  view->addSeparator();
  for (QDockWidget* dock : {m_documentsDock, m_historyDock, m_defectsDock, m_logDock}) {
    view->addAction(dock->toggleViewAction());
  }
  view->addSeparator();
  view->addAction(m_viewActions->darkTheme());

  QMenu* repair = menuBar()->addMenu(tr("&Repair"));
  repair->addActions(m_repairActions.all());

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  QAction* keys = help->addAction(tr("&Keys and mouse"), QKeySequence(Qt::Key_F1), this, [this] { showKeys(*this); });
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
  quick->addSeparator();
  quick->addActions({m_repairActions.repairAll(), m_repairActions.previous(), m_repairActions.next(),
                     m_repairActions.fill(), m_repairActions.keepOpen()});
  auto* stretch = new QWidget(quick);
  stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  quick->addWidget(stretch);
  quick->addAction(m_viewActions->darkTheme());
  nameButtons(*quick);
  for (QAction* named : {m_repairActions.repairAll(), m_repairActions.fill()}) {
    static_cast<QToolButton*>(quick->widgetForAction(named))->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }

  QToolBar* strip = addBar(*this, Qt::LeftToolBarArea, "panelStrip", tr("Panels"));
  for (QDockWidget* dock : {m_documentsDock, m_historyDock, m_defectsDock, m_logDock}) {
    strip->addAction(dock->toggleViewAction());
  }
  nameButtons(*strip);
}

}  // namespace handwheel
