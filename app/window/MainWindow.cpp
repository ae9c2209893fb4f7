// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/MainWindow.h"

#include "panels/DefectModel.h"
#include "panels/DefectsPanel.h"
#include "panels/DocumentsPanel.h"
#include "panels/HintBar.h"
#include "panels/JobBar.h"
#include "panels/MessageBar.h"
#include "panels/NextStepCard.h"
#include "panels/StartPage.h"
#include "viewport/Viewport.h"
#include "window/DocumentScene.h"
#include "window/DocumentTabs.h"
#include "window/NextSteps.h"
#include "window/OpenDocument.h"
#include "window/ViewActions.h"
#include "window/WindowLayout.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QMimeData>
#include <QShortcut>
#include <QStackedWidget>
#include <QUrl>

namespace handwheel {

MainWindow::MainWindow(QThreadPool& pool)
    : m_jobs(JobRunner::Policy::Queue, pool),
      m_preview(pool),
      m_search(pool),
      m_tabs(new DocumentTabs(this)),
      m_fileActions(this, *m_tabs, m_jobs, m_recent, m_log),
      m_repairJobs(*m_tabs, m_jobs, m_log),
      m_repairActions(*m_tabs, m_selection, m_repairJobs, m_preview),
      m_showDefects(tr("&Show the list")),
      m_quit(tr("&Quit")) {
  setObjectName(QStringLiteral("mainWindow"));
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  m_showDefects.setObjectName(QStringLiteral("showDefects"));
  m_showDefects.setToolTip(tr("Show the whole model and the list of its defects"));
  connect(&m_showDefects, &QAction::triggered, this, &MainWindow::showDefects);
  buildCentre();
  buildDocks();
  buildStatusBar();
  buildMenus();
  buildToolBars();
  connectDocuments();
  connectSelection();
  connectJobs();
  connectStartPage();
  restoreLayout(*this, {m_documentsDock, m_historyDock, m_logDock});
  showDocument(nullptr);
}

// The parts refer to one another, so they go in the reverse order of their making, before the widgets do.
MainWindow::~MainWindow() {
  m_defectsDock->disconnect(this);  // it hides last of all
  m_scene->setDocument(nullptr);
  m_defects->setInspection(nullptr);
  m_selection.setDocument(nullptr);
  m_search.setDocument(nullptr);
}

bool MainWindow::isSettled() const {
  return m_jobs.isIdle() && m_search.isIdle() && m_preview.state().kind != PreviewState::Kind::Working;
}

void MainWindow::connectDocuments() {
  connect(m_tabs, &DocumentTabs::added, this, [this](OpenDocument* opened) {
    m_undo.addStack(opened->document.history());
    m_documents->addDocument(&opened->document);
    connect(&opened->document, &MeshDocument::fileChanged, this, [this] {
      updateTitle();
      updateCard();
    });
    connect(&opened->inspection, &Inspection::changed, this, [this] {
      updateFigures();
      updateCard();
    });
  });
  connect(m_tabs, &DocumentTabs::closing, this, [this](OpenDocument* closed) {
    showDocument(nullptr);  // whoever points at it lets go
    m_undo.removeStack(closed->document.history());
    m_documents->removeDocument(&closed->document);
    closed->document.disconnect(this);
    closed->inspection.disconnect(this);
  });
  connect(m_tabs, &DocumentTabs::currentChanged, this, &MainWindow::showDocument);
  const auto openOf = [this](const MeshDocument* document) -> OpenDocument* {
    for (const auto& each : m_tabs->all()) {
      if (&each->document == document) return each.get();
    }
    return nullptr;
  };
  connect(m_documents, &DocumentsPanel::activated, this,
          [this, openOf](MeshDocument* document) { m_tabs->setCurrent(openOf(document)); });
  connect(m_documents, &DocumentsPanel::visibilityChanged, this, [this, openOf](MeshDocument* document, bool visible) {
    openOf(document)->visible = visible;
    m_scene->refreshVisibility();
  });
  connect(&m_fileActions, &FileActions::message, m_messages, &MessageBar::showMessage);
}

void MainWindow::connectSelection() {
  connect(&m_selection, &Selection::changed, this, [this] {
    m_defects->setSelectedLoop(m_selection.loop());
    updateHints();
    updateCard();
  });
  connect(&m_selection, &Selection::hoverChanged, this,
          [this] { m_defects->setHighlightedLoop(m_selection.hovered()); });
  connect(m_defects, &DefectsPanel::loopHovered, &m_selection, &Selection::hover);
  connect(m_defects, &DefectsPanel::loopSelected, &m_selection, &Selection::select);
  connect(m_defects, &DefectsPanel::defectActivated, m_scene, &DocumentScene::showPlace);
  connect(m_defects->settings(), &HoleSettings::methodChanged, &m_repairActions, &RepairActions::setMethod);
  m_defects->settings()->setMethod(m_repairActions.method());
  connect(&m_preview, &HolePreview::changed, this, [this] { m_defects->settings()->showPreview(m_preview.state()); });
  connect(&m_repairActions, &RepairActions::showLoopRequested, m_scene, &DocumentScene::showLoop);
  connect(m_card, &NextStepCard::dismissed, this, [this] {
    m_tabs->current()->cardDismissed = true;
    updateCard();
  });
  connect(m_card, &NextStepCard::covers, m_viewport, &Viewport::setCovered);
  auto* space = new QShortcut(QKeySequence(Qt::Key_Space), m_viewport, nullptr, nullptr, Qt::WidgetShortcut);
  connect(space, &QShortcut::activated, m_repairActions.next(), &QAction::trigger);
}

void MainWindow::connectJobs() {
  connect(&m_jobs, &JobRunner::started, m_jobBar, &JobBar::showJob);
  connect(&m_jobs, &JobRunner::progressed, m_jobBar, &JobBar::setProgress);
  connect(&m_jobs, &JobRunner::finished, m_jobBar, &JobBar::hideJob);
  connect(&m_repairJobs, &RepairJobs::workingChanged, this, &MainWindow::updateCard);
  connect(m_jobBar, &JobBar::cancelRequested, &m_jobs, &JobRunner::cancel);
}

void MainWindow::connectStartPage() {
  m_start->setSampleAvailable(!samplePath().isEmpty());
  m_start->setRecentFiles(m_recent.paths());
  connect(&m_recent, &RecentFiles::changed, this, [this] { m_start->setRecentFiles(m_recent.paths()); });
  connect(m_start, &StartPage::sampleRequested, m_fileActions.openSample(), &QAction::trigger);
  connect(m_start, &StartPage::openRequested, m_fileActions.open(), &QAction::trigger);
  connect(m_start, &StartPage::recentRequested, this, [this](const QString& path) { openPaths({path}); });
  connect(m_start, &StartPage::clearRecentRequested, &m_recent, &RecentFiles::clear);
}

void MainWindow::showDocument(OpenDocument* document) {
  m_preview.forget();
  m_tabs->setVisible(document != nullptr);
  m_stack->setCurrentWidget(document ? static_cast<QWidget*>(m_viewport) : m_start);
  m_undo.setActiveStack(document ? document->document.history() : nullptr);
  m_defects->setInspection(document ? &document->inspection : nullptr);
  m_documents->setCurrent(document ? &document->document : nullptr);
  m_scene->setDocument(document);
  m_search.setDocument(document);
  m_selection.setDocument(document);
  for (QAction* action : m_viewActions->views() + m_viewActions->shadings()) action->setEnabled(document != nullptr);
  m_viewActions->fit()->setEnabled(document != nullptr);
  if (document) m_viewport->setFocus();
  updateTitle();
  updateFigures();
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
  const std::size_t faces = document->document.mesh().liveFaceCount();
  m_figures->setText(tr("%1 triangles").arg(QLocale().toString(static_cast<qulonglong>(faces))));
}

void MainWindow::updateCard() {
  const OpenDocument* document = m_tabs->current();
  if (!document || m_selection.loop() >= 0 || m_repairJobs.isWorking()) return m_card->showStep({});
  QAction* showList = m_defectsDock->isVisible() ? nullptr : &m_showDefects;
  m_card->showStep(nextStepFor(*document, {m_repairActions.repairAll(), m_repairActions.removeDebris(),
                                           m_repairActions.goOneByOne(), showList, m_fileActions.saveAs()}));
}

void MainWindow::updateHints() {
  std::vector<Hint> hints;
  if (!m_tabs->current()) {
    hints = {{tr("Ctrl+O"), tr("open a file")}, {tr("Drop"), tr("files anywhere")}};
  } else if (m_selection.loop() >= 0) {
    hints = {{tr("Enter"), tr("fill")},   {tr("K"), tr("keep open")},  {tr("N"), tr("next hole")},
             {tr("Esc"), tr("deselect")}, {tr("Middle"), tr("orbit")}, {tr("Shift+middle"), tr("pan")},
             {tr("Wheel"), tr("zoom")}};
    if (!m_repairActions.fill()->isEnabled()) hints.erase(hints.begin());
  } else {
    if (m_repairActions.next()->isEnabled()) hints = {{tr("Click"), tr("select a hole")}, {tr("N"), tr("next hole")}};
    hints.insert(hints.end(), {{tr("Middle"), tr("orbit")},
                               {tr("Shift+middle"), tr("pan")},
                               {tr("Wheel"), tr("zoom")},
                               {tr("F"), tr("fit")}});
  }
  m_hints->setHints(std::move(hints));
}

void MainWindow::showDefects() {
  m_defectsDock->show();
  m_defectsDock->raise();
  m_viewport->fit();
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
