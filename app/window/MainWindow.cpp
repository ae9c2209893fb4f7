// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/MainWindow.h"

#include "controls/CommandPalette.h"
#include "controls/PreferencesDialog.h"
#include "panels/DocumentsPanel.h"
#include "panels/HintBar.h"
#include "panels/JobBar.h"
#include "panels/MessageBar.h"
#include "panels/NextStepCard.h"
#include "panels/StartPage.h"
#include "theme/Icons.h"
#include "viewport/Viewport.h"
#include "window/DocumentProperties.h"
#include "window/DocumentTabs.h"
#include "window/OpenDocument.h"
#include "window/Thumbnails.h"
#include "window/ToolHost.h"
#include "window/ToolPanel.h"
#include "window/ViewActions.h"
#include "window/ViewSettings.h"
#include "window/WindowLayout.h"

#include <QActionGroup>
#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QStackedWidget>
#include <QToolBar>
#include <QUrl>
#include <algorithm>

namespace handwheel {

MainWindow::MainWindow(QThreadPool& pool, const KindSet& kinds)
    : m_jobs(JobRunner::Policy::Queue, pool),
      m_pool(pool),
      m_tabs(new DocumentTabs(this)),
      m_fileActions(this, kinds.documents, m_uis, *m_tabs, m_jobs, m_recent, m_log),
      m_autosave(*m_tabs, m_fileActions.loader(), pool, m_log, m_services),
      m_showPanel(tr("&Show the list")),
      m_quit(tr("&Quit")) {
  setObjectName(QStringLiteral("mainWindow"));
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  m_showPanel.setObjectName(QStringLiteral("showPanel"));
  m_showPanel.setToolTip(tr("Show the whole model and its panel"));
  connect(&m_showPanel, &QAction::triggered, this, &MainWindow::showPanel);
  buildCentre();
  makeKinds(kinds);
  buildDocks();
  buildStatusBar();
  buildMenus();
  buildToolBars();
  connectDocuments();
  connectJobs();
  connectStartPage();
  m_palette = new CommandPalette(this);
  findChild<QMenu*>(QStringLiteral("helpMenu"))->insertAction(nullptr, m_palette->action());
  m_keys.setActions(findChildren<QAction*>(), menuBar());
  restoreLayout(*this, {m_documentsDock, m_historyDock, m_fidelityDock, m_statusDock, m_logDock});
  prefer(loadPreferences());
  showDocument(nullptr);
}

// The parts refer to one another, so they go in the reverse order of their making, before the widgets do.
MainWindow::~MainWindow() {
  m_kindDock->disconnect(this);  // it hides last of all
  m_tools->stop();
  for (const auto& [id, ui] : m_uis) ui->setDocument(nullptr);
}

void MainWindow::makeKinds(const KindSet& kinds) {
  const WindowParts parts{.window = this,
                          .tabs = *m_tabs,
                          .jobs = m_jobs,
                          .pool = m_pool,
                          .log = m_log,
                          .viewport = *m_viewport,
                          .services = m_services,
                          .tools = *m_tools,
                          .fidelity = m_fidelity,
                          .saveAs = m_fileActions.saveAs(),
                          .isPanelVisible = [this] { return m_kindDock->isVisible(); },
                          .showPanel = &m_showPanel};
  for (const auto& [id, make] : kinds.windows) {
    auto made = make(parts);
    connect(made.get(), &KindUi::stateChanged, this, [this, from = made.get()] {
      if (from != ui()) return;
      updateFigures();
      updateHints();
      updateCard();
    });
    toolActions(*made);
    connect(made.get(), &KindUi::message, m_messages, &MessageBar::showMessage);
    m_uis.emplace(id, std::move(made));
  }
}

KindUi* MainWindow::ui() const {
  const OpenDocument* document = m_tabs->current();
  return document ? &document->ui : nullptr;
}

bool MainWindow::isSettled() const {
  return m_jobs.isIdle() &&
         std::all_of(m_uis.begin(), m_uis.end(), [](const auto& each) { return each.second->isSettled(); });
}

void MainWindow::connectDocuments() {
  connect(m_tabs, &DocumentTabs::added, this, [this](OpenDocument* opened) {
    m_undo.addStack(opened->document.history());
    m_documents->addDocument(&opened->document);
    connect(&opened->document, &Document::fileChanged, this, [this] {
      updateTitle();
      updateCard();
    });
  });
  connect(m_tabs, &DocumentTabs::closing, this, [this](OpenDocument* closed) {
    if (closed == m_tabs->current() && closed->visible && !closed->document.file().path.empty()) {
      storeThumbnail(closed->document.path(), m_viewport->grabFramebuffer(), m_pool);
    }
    showDocument(nullptr);  // whoever points at it lets go
    closed->ui.forget(closed);
    m_undo.removeStack(closed->document.history());
    m_documents->removeDocument(&closed->document);
    closed->document.disconnect(this);
  });
  connect(m_tabs, &DocumentTabs::currentChanged, this, &MainWindow::showDocument);
  const auto openOf = [this](const Document* document) -> OpenDocument* {
    for (const auto& each : m_tabs->all()) {
      if (&each->document == document) return each.get();
    }
    return nullptr;
  };
  connect(m_documents, &DocumentsPanel::activated, this,
          [this, openOf](Document* document) { m_tabs->setCurrent(openOf(document)); });
  connect(m_documents, &DocumentsPanel::visibilityChanged, this, [this, openOf](Document* document, bool visible) {
    OpenDocument* changed = openOf(document);
    changed->visible = visible;
    if (changed == m_tabs->current()) changed->ui.refreshVisibility();
  });
  connect(&m_fileActions, &FileActions::message, m_messages, &MessageBar::showMessage);
  connect(&m_autosave, &Autosave::message, m_messages, &MessageBar::showMessage);
  connect(m_card, &NextStepCard::dismissed, this, [this] {
    m_tabs->current()->cardDismissed = true;
    updateCard();
  });
  connect(m_card, &NextStepCard::covers, m_viewport, &Viewport::setCovered);
}

void MainWindow::connectJobs() {
  connect(m_tools, &ToolHost::updated, this, &MainWindow::updateHints);
  connect(&m_tools->runner(), &ToolRunner::failed, this, [this](const QString& reason) {
    m_messages->showMessage({Message::Weight::Error,
                             tr("The tool failed and was put away"),
                             reason,
                             tr("The document is as it was before."),
                             {},
                             {}});
  });
  connect(&m_jobs, &JobRunner::started, m_jobBar, &JobBar::showJob);
  connect(&m_jobs, &JobRunner::progressed, m_jobBar, &JobBar::setProgress);
  connect(&m_jobs, &JobRunner::finished, m_jobBar, &JobBar::hideJob);
  connect(m_jobBar, &JobBar::cancelRequested, &m_jobs, &JobRunner::cancel);
}

void MainWindow::connectStartPage() {
  m_start->setSampleAvailable(StartPage::Sample::Scan, m_fileActions.openSample()->isEnabled());
  m_start->setSampleAvailable(StartPage::Sample::Cell, m_fileActions.openRobotSample()->isEnabled());
  m_start->setSampleAvailable(StartPage::Sample::Lathe, true);
  connect(m_start, &StartPage::sampleChosen, this, [this](StartPage::Sample sample) {
    switch (sample) {
      case StartPage::Sample::Scan:
        return m_fileActions.openSample()->trigger();
      case StartPage::Sample::Lathe:
        return m_fileActions.newWorkpiece()->trigger();
      case StartPage::Sample::Cell:
        return m_fileActions.openRobotSample()->trigger();
    }
  });
  m_start->setPictures(thumbnailOf);
  m_start->setRecentFiles(m_recent.paths());
  connect(&m_recent, &RecentFiles::changed, this, [this] { m_start->setRecentFiles(m_recent.paths()); });
  connect(m_start, &StartPage::openRequested, m_fileActions.open(), &QAction::trigger);
  connect(m_start, &StartPage::recentRequested, this, [this](const QString& path) { openPaths({path}); });
  connect(m_start, &StartPage::clearRecentRequested, &m_recent, &RecentFiles::clear);
}

void MainWindow::showDocument(OpenDocument* document) {
  KindUi* present = document ? &document->ui : nullptr;
  m_tabs->setVisible(document != nullptr);
  m_stack->setCurrentWidget(document ? static_cast<QWidget*>(m_viewport) : m_start);
  m_undo.setActiveStack(document ? document->document.history() : nullptr);
  m_documents->setCurrent(document ? &document->document : nullptr);
  m_properties->setDocument(document ? &document->document : nullptr);
  for (const auto& [id, each] : m_uis) {
    if (each.get() != present) each->setDocument(nullptr);
  }
  if (present) present->setDocument(document);
  showKind(present);
  m_viewSettings->refresh();
  for (QAction* action : m_viewActions->views() + m_viewActions->shadings()) action->setEnabled(document != nullptr);
  m_viewActions->fit()->setEnabled(document != nullptr);
  if (document) m_viewport->setFocus();
  updateTitle();
  updateFigures();
  updateHints();
  updateCard();
}

// Panel, menu and tools of the kind of the present document. Without a document, those of the last one stay.
void MainWindow::showKind(KindUi* present) {
  m_kindMenu->setEnabled(present != nullptr);
  m_kindBar->setEnabled(present != nullptr);
  if (!present) return m_tools->stop();
  m_kindPanels->setCurrentWidget(present->panel());
  m_kindDock->setWindowTitle(present->panelTitle());
  m_kindDock->setAccessibleName(present->panelTitle());
  m_kindMenu->setTitle(present->menuTitle());
  const QList<QAction*> tools = toolActions(*present);
  m_kindMenu->clear();
  m_kindMenu->addActions(tools);
  m_kindMenu->addSeparator();
  m_kindMenu->addActions(present->menu());
  m_kindBar->clear();
  m_kindBar->addActions(tools);
  m_kindBar->addSeparator();
  m_kindBar->addActions(present->toolBar());
  nameButtons(*m_kindBar);
  if (!tools.isEmpty()) tools.first()->trigger();
}

// One action for each tool of the kind; they exclude each other. Made once.
QList<QAction*> MainWindow::toolActions(KindUi& kind) {
  const QString name = QStringLiteral("tools/%1").arg(reinterpret_cast<quintptr>(&kind));
  auto* group = findChild<QActionGroup*>(name);
  if (group) return group->actions();
  group = new QActionGroup(this);
  group->setObjectName(name);
  for (const ToolOffer& offer : kind.tools()) {
    QAction* action = group->addAction(icon(offer.icon), offer.text);
    action->setObjectName(offer.id);
    action->setCheckable(true);
    action->setIconVisibleInMenu(false);
    action->setShortcut(offer.key);
    connect(action, &QAction::triggered, this, [this, &kind, make = offer.make] {
      if (ui() == &kind) m_tools->start(make(), m_tabs->current()->document);
    });
  }
  return group->actions();
}

void MainWindow::updateTitle() {
  const OpenDocument* document = m_tabs->current();
  setWindowTitle(document ? tr("%1[*] — Handwheel").arg(document->document.name()) : QStringLiteral("Handwheel"));
  setWindowModified(document && document->document.isModified());
}

void MainWindow::updateFigures() {
  const OpenDocument* document = m_tabs->current();
  m_figures->setVisible(document != nullptr);
  m_unit->setVisible(document != nullptr);
  if (!document) return;
  m_figures->setText(document->ui.figures());
  m_unit->setText(QString::fromLatin1(symbolOf(document->document.displayUnit())));
  m_viewport->setDisplayUnit(document->document.displayUnit());
}

void MainWindow::updateCard() {
  const OpenDocument* document = m_tabs->current();
  m_card->showStep(document && !document->cardDismissed ? document->ui.nextStep() : NextStep{});
}

void MainWindow::updateHints() {
  std::vector<Hint> hints;
  if (KindUi* present = ui()) {
    hints = present->hints();
    for (const auto& [input, effect] : m_viewport->navigationHints()) hints.push_back({input, effect});
    hints.push_back({m_viewActions->fit()->shortcut().toString(QKeySequence::NativeText), tr("fit")});
  } else {
    hints = {{tr("Ctrl+O"), tr("open a file")}, {tr("Drop"), tr("files anywhere")}};
  }
  m_hints->setHints(std::move(hints));
}

void MainWindow::showPanel() {
  m_kindDock->show();
  m_kindDock->raise();
  m_viewport->fit();
}

void MainWindow::showPreferences() {
  if (auto* open = findChild<PreferencesDialog*>()) return open->raise();
  std::vector<NavigationChoice> choices;
  for (NavigationPreset preset : kNavigationPresets) {
    QStringList bindings;
    for (const auto& [input, effect] : navigationHints(preset)) bindings << tr("%1: %2").arg(input, effect);
    choices.push_back({idOf(preset), nameOf(preset), bindings.join(QStringLiteral(", "))});
  }
  auto* dialog = new PreferencesDialog(&m_keys, std::move(choices), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PreferencesDialog::changed, this, &MainWindow::prefer);
  dialog->show();
}

void MainWindow::prefer(const Preferences& preferences) {
  m_viewport->setNavigationPreset(presetOf(preferences.navigation));
  m_autosave.setInterval(preferences.autosaveSeconds);
  updateHints();
}

QList<QDockWidget*> MainWindow::docks() const {
  return {m_documentsDock,  m_historyDock, m_kindDock, m_toolDock,
          m_propertiesDock, m_viewDock,    m_logDock,  m_statusDock};
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (m_tabs->all().empty()) {
    saveLayout(*this);
    return event->accept();
  }
  event->ignore();
  m_fileActions.requestCloseAll([this] { close(); });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) paths << url.toLocalFile();
  }
  openPaths(paths);
  event->acceptProposedAction();
}

}  // namespace handwheel
