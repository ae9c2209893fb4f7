// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Reactions of the main window when documents are opened, changed and closed.
#include "controls/FocusedField.h"
#include "panels/DocumentsPanel.h"
#include "panels/HintBar.h"
#include "panels/JobBar.h"
#include "panels/MessageBar.h"
#include "panels/StartPage.h"
#include "panels/SuggestionCard.h"
#include "viewport/Viewport.h"
#include "window/MainWindow.h"
#include "window/PanelEscape.h"
#include "window/ViewActions.h"
#include "window/ViewSettings.h"
#include "window/documents/DocumentProperties.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/haptics/DeviceView.h"
#include "window/haptics/SessionDevicePanel.h"
#include "window/haptics/SpaceMouseNavigation.h"
#include "window/tools/ToolChoice.h"
#include "window/tools/ToolHost.h"
#include "window/tools/ToolPanel.h"

#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QUndoView>

namespace handwheel {

namespace {

// Name in the panel of the state of an undo stack before its first step.
constexpr const char* kBeginning = "beginning";

// A project keeps what was made of its steps, not the steps.
QString beginningOf(const Document& opened) {
  if (opened.file().path.empty()) return MainWindow::tr("As created");
  return opened.file().isContainer ? MainWindow::tr("History begins when the file was opened")
                                   : MainWindow::tr("As in the file");
}

}  // namespace

void MainWindow::connectDocuments() {
  connect(m_tabs, &DocumentTabs::added, this, [this](DocumentTab* opened) {
    m_undo.addStack(opened->document.history());
    opened->document.history()->setProperty(kBeginning, beginningOf(opened->document));
    m_documents->addDocument(&opened->document);
    m_documents->setPicture(&opened->document, Thumbnails::of(opened->document.path()));
    connect(&opened->document, &Document::fileChanged, this, [this] {
      updateTitle();
      updateFigures();
      updateCard();
    });
  });
  connect(m_tabs, &DocumentTabs::closing, this, [this](DocumentTab* closed) {
    if (closed == m_shown) showDocument(nullptr);  // whoever points at it lets go
    m_jobs.forget(&closed->document);
    closed->ui.forget(closed);
    m_messages->forget(&closed->document);
    m_undo.removeStack(closed->document.history());
    m_documents->removeDocument(&closed->document);
    closed->document.disconnect(this);
  });
  connect(m_tabs, &DocumentTabs::currentChanged, this, [this](DocumentTab* current) {
    if (current != m_shown || !current) showDocument(current);
  });
}

void MainWindow::connectDocumentsPanel() {
  const auto openOf = [this](const Document* document) -> DocumentTab* {
    for (const auto& each : m_tabs->all()) {
      if (&each->document == document) return each.get();
    }
    return nullptr;
  };
  connect(m_documents, &DocumentsPanel::chosen, this,
          [this, openOf](Document* document) { m_tabs->setCurrent(openOf(document)); });
  connect(m_documents, &DocumentsPanel::activated, this, [this, openOf](Document* document) {
    m_tabs->setCurrent(openOf(document));
    m_viewport->setFocus();
  });
  connect(m_documents, &DocumentsPanel::visibilityChanged, this, [this, openOf](Document* document, bool visible) {
    DocumentTab* changed = openOf(document);
    changed->visible = visible;
    if (changed != m_tabs->current()) return;
    changed->ui.refreshVisibility();
    m_tools->setVisible(visible);
  });
}

void MainWindow::connectMessages() {
  connect(&m_fileActions, &FileActions::message, m_messages, &MessageBar::showMessage);
  connect(&m_copies, &CopyActions::message, m_messages, &MessageBar::showMessage);
  connect(&m_fileActions, &FileActions::saved, m_messages, &MessageBar::withdraw);
  connect(&m_autosave, &Autosave::message, m_messages, &MessageBar::showMessage);
  connect(&m_haptics, &HapticSession::message, m_messages, &MessageBar::showMessage);
  connect(m_spaceMouse, &SpaceMouseNavigation::message, m_messages, &MessageBar::showMessage);
  connect(&m_tools->runner(), &ToolRunner::failed, this, [this](const QString& reason) {
    m_messages->showMessage({Message::Weight::Error,
                             tr("The tool failed and was closed"),
                             reason,
                             tr("The document is as it was before."),
                             {},
                             {},
                             {},
                             {},
                             m_shown ? &m_shown->document : nullptr});
  });
  connect(m_card, &SuggestionCard::dismissed, this, [this] {
    m_tabs->current()->cardDismissed = true;
    updateCard();
  });
  connect(m_card, &SuggestionCard::covers, m_viewport, &Viewport::setCovered);
}

void MainWindow::connectTools() {
  m_autosave.watch(*m_tools);
  connect(m_tools, &ToolHost::updated, this, &MainWindow::updateHints);
  connect(m_tools, &ToolHost::previewed, this, [this](const ToolPreview& preview) {
    if (m_shown) m_shown->ui.showPreview(preview);
  });
  m_tools->setContextMenu([this](const QPointF& position) {
    QMenu* menu = m_shown ? m_shown->ui.menuAt(position) : nullptr;
    if (menu) menu->popup(m_viewport->mapToGlobal(position.toPoint()));
    return menu != nullptr;
  });
  connect(m_toolChoice, &ToolChoice::otherChosen, m_toolDock, &QWidget::raise);
  connect(m_toolChoice, &ToolChoice::defaultChosen, this, [this] {
    if (!m_toolPanel->visibleRegion().isEmpty()) m_kindDock->raise();
  });
}

void MainWindow::connectRecordings() {
  connect(&m_fileActions, &FileActions::aboutToClose, &m_recordings, &Recordings::finish);
  connect(&m_recordings, &Recordings::message, m_messages, &MessageBar::showMessage);
  connect(&m_recordings.playback(), &Playback::moved, m_deviceView,
          [this] { m_deviceView->showInstead(m_recordings.playback().cursor()); });
  const auto noteTool = [this] {
    const Tool* const tool = m_tools->runner().tool();
    m_recordings.noteTool(tool ? tool->recordedName() : std::string());
  };
  connect(&m_tools->runner(), &ToolRunner::updated, &m_recordings, noteTool);
  connect(&m_tools->runner(), &ToolRunner::ended, &m_recordings, noteTool);
}

void MainWindow::connectJobs() {
  const auto show = [this] { m_jobBar->setJobs(m_jobs.jobs()); };
  connect(&m_jobs, &JobRunner::changed, m_jobBar, show);
  connect(&m_jobs, &JobRunner::progressed, m_jobBar, show);
  connect(m_jobBar, &JobBar::cancelJobRequested, &m_jobs, &JobRunner::cancel);
  connect(&m_jobs, &JobRunner::cancelled, this, &MainWindow::reportCancelled);
  const auto cancelLatest = [this] { return m_shown && m_jobs.cancelLatestOf(&m_shown->document); };
  m_tools->setEscape(cancelLatest);
  new PanelEscape(cancelLatest, this);
}

void MainWindow::reportCancelled(const JobStatus& job, const Document* document) {
  Message said{Message::Weight::Info, tr("“%1” was cancelled").arg(job.name)};
  if (document) {
    said.detail = tr("%1 is as it was.").arg(document->name());
    said.about = document;
    said.isOver = [document, revision = document->revision()] { return document->revision() != revision; };
  }
  m_log.add(said.detail.isEmpty() ? said.title : said.title + QStringLiteral(". ") + said.detail);
  m_messages->showMessage(said);
}

void MainWindow::connectStartPage() {
  m_start->setTiles(m_fileActions.tiles());
  connect(m_start, &StartPage::tileChosen, &m_fileActions, &FileActions::begin);
  m_start->setPictures(Thumbnails::of, [this](const QString& path) { return m_fileActions.iconNameFor(path); });
  const auto showRecent = [this] { m_start->setRecentFiles(m_recent.paths()); };
  showRecent();
  connect(&m_recent, &RecentFiles::changed, this, showRecent);
  connect(&m_thumbnails, &Thumbnails::stored, this, showRecent);
  connect(m_start, &StartPage::openRequested, m_fileActions.open(), &QAction::trigger);
  connect(m_start, &StartPage::recentRequested, this, [this](const QString& path) { openPaths({path}); });
  connect(m_start, &StartPage::clearRecentRequested, &m_recent, &RecentFiles::clear);
}

void MainWindow::showDocument(DocumentTab* document) {
  if (document != m_shown) commitFocusedField();  // its text is of the document that was shown until now
  // A user who goes through the documents with keys goes on with them. Fields that disappear pass the focus to the next
  // widget.
  const QWidget* const focused = focusWidget();
  const bool isByKeys = m_documents->isAncestorOf(focused) || m_tabs->isAncestorOf(focused);
  KindUi* present = document ? &document->ui : nullptr;
  storePicture();
  m_toolChoice->putAway();
  m_shown = document;
  m_tabs->setVisible(document != nullptr);
  m_stack->setCurrentWidget(document ? static_cast<QWidget*>(m_viewport) : m_start);
  m_undo.setActiveStack(document ? document->document.history() : nullptr);
  if (document) m_history->setEmptyLabel(document->document.history()->property(kBeginning).toString());
  m_documents->setCurrent(document ? &document->document : nullptr);
  m_messages->setDocument(document ? &document->document : nullptr);
  m_properties->setDocument(document ? &document->document : nullptr,
                            [present](const Document& shown) { return present->listedProperties(shown); });
  m_recordings.setDocument(document ? &document->document : nullptr);
  for (const auto& [id, each] : m_uis) {
    if (each.get() != present) each->setDocument(nullptr);
  }
  if (present) present->setDocument(document);
  m_kindMenus->show(present);
  m_tools->setVisible(!document || document->visible);
  m_toolChoice->takeUp(document);
  m_viewSettings->setSectionAxis(document ? document->ui.sectionAxis() : std::nullopt);
  m_viewSettings->followModel();
  m_deviceView->followModel();
  // The hand is in the view of this document by now: its axes are named after that.
  m_deviceDock->findChild<SessionDevicePanel*>()->setTurningAxis(document ? document->ui.sectionAxis() : std::nullopt);
  if (!document) m_viewSettings->setSectionFigures({});
  for (QAction* action : m_viewActions->views() + m_viewActions->shadings()) action->setEnabled(document != nullptr);
  m_viewActions->fit()->setEnabled(document != nullptr);
  if (document && !isByKeys) m_viewport->setFocus();
  m_pictureTimer.start();
  updateTitle();
  updateFigures();
  updateHints();
  updateCard();
}

// Stores a picture of the document in view, for the list of documents and the start page; not if it has not been drawn
// whole.
void MainWindow::storePicture() {
  if (!m_shown || !m_shown->visible || !m_viewport->isPickingReady()) return;
  const QImage picture = m_viewport->grabFramebuffer();
  if (picture.isNull()) return;
  const QImage small = Thumbnails::pictureOf(picture);
  m_documents->setPicture(&m_shown->document, QPixmap::fromImage(small));
  if (!m_shown->document.file().path.empty()) m_thumbnails.store(m_shown->document.path(), small);
}

void MainWindow::updateTitle() {
  const DocumentTab* document = m_tabs->current();
  setWindowTitle(document ? tr("%1[*] — Handwheel").arg(document->document.name()) : QStringLiteral("Handwheel"));
  setWindowModified(document && document->document.isModified());
}

void MainWindow::updateFigures() {
  const DocumentTab* document = m_tabs->current();
  m_figures->setVisible(document != nullptr);
  m_unit->setVisible(document != nullptr);
  if (!document) return;
  const LengthUnit unit = document->document.displayUnit();
  const QString symbol = QString::fromLatin1(symbolOf(unit));
  m_figures->setText(document->ui.statistics());
  m_unit->setText(symbol);
  m_unit->setToolTip(tr("Lengths are shown in %1: the display unit of the document, among its properties").arg(symbol));
  m_viewport->setDisplayUnit(unit);
  m_viewSettings->setLengthUnit(unit);
}

void MainWindow::updateCard() {
  const DocumentTab* document = m_tabs->current();
  m_card->showStep(document && !document->cardDismissed ? document->ui.suggestion() : Suggestion{});
}

void MainWindow::updateHints() {
  m_hints->setHints(hints());
}

std::vector<Hint> MainWindow::hints() {
  const auto keyOf = [](const QAction* action) { return action->shortcut().toString(QKeySequence::NativeText); };
  KindUi* present = ui();
  if (!present) return {{keyOf(m_fileActions.open()), tr("open a file")}, {tr("Drop"), tr("files anywhere")}};
  std::vector<Hint> hints = present->hints();
  for (const auto& [input, effect] : m_viewport->navigationHints()) hints.push_back({input, effect});
  hints.push_back({keyOf(m_viewActions->fit()), tr("fit")});
  return hints;
}

}  // namespace handwheel
