// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/MainWindow.h"

#include "controls/CommandPalette.h"
#include "controls/PreferencesDialog.h"
#include "viewport/Viewport.h"
#include "window/DisabledReasons.h"
#include "window/PopupKeys.h"
#include "window/ViewSettings.h"
#include "window/WindowLayout.h"
#include "window/documents/DocumentProperties.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileDialogs.h"
#include "window/haptics/SpaceMouseNavigation.h"
#include "window/tools/ToolChoice.h"

#include <QCloseEvent>
#include <QDialog>
#include <QDockWidget>
#include <QMenuBar>
#include <QMimeData>
#include <QTabBar>
#include <QUrl>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kPictureDelayMs = 1000;
constexpr QSize kLeastSize(800, 600);  // logical pixels: of a small screen

}  // namespace

MainWindow::MainWindow(QThreadPool& pool, const KindSet& kinds, Drivers drivers)
    : m_jobs(JobRunner::Policy::Queue, pool, this),
      m_thumbnails(pool),
      m_fidelity(this),
      m_calibrator(m_fidelity, pool, defaultCalibrationFile(), this),
      m_haptics({m_jobs, pool, m_services, m_servoClock}, std::move(drivers), this),
      m_touch(m_haptics),
      m_recordings({this, m_haptics, m_jobs, m_log, m_servoClock}, this),
      m_pool(pool),
      m_tabs(new DocumentTabs(this)),
      m_fileActions(this, kinds.documents, m_uis, *m_tabs, m_jobs, m_recent, m_log),
      m_copies(this, kinds.documents, m_uis, *m_tabs, m_jobs,
               [this](OpenedFile opened) { return m_fileActions.loader().openUnsaved(std::move(opened)); }),
      m_autosave(*m_tabs, m_fileActions.loader(), m_log, m_services),
      m_showPanel(tr("&Show the list"), this),
      m_quit(tr("&Quit"), this) {
  setObjectName(QStringLiteral("mainWindow"));
  m_jobs.setObjectName(QStringLiteral("jobs"));
  setAcceptDrops(true);
  // Without a size of its own Qt would enlarge the window, and beyond the screen, as soon as the panels ask for more.
  setMinimumSize(kLeastSize);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  new PopupKeys(this);
  new DisabledReasons(this);
  new FileDialogLayout(this);
  buildCentre();
  makeKinds(kinds);
  buildDocks();
  buildStatusBar();
  buildMenus();
  buildToolBars();
  placeKinds();
  addSearch();
  connectDocuments();
  connectDocumentsPanel();
  connectMessages();
  connectTools();
  connectRecordings();
  connectJobs();
  connectStartPage();
  m_pictureTimer.setSingleShot(true);
  m_pictureTimer.setInterval(kPictureDelayMs);
  connect(&m_pictureTimer, &QTimer::timeout, this, &MainWindow::storePicture);
  m_keys.setActions(findChildren<QAction*>(), menuBar());
  restoreLayout(*this, {m_documentsDock, m_historyDock, m_fidelityDock, m_statusDock, m_logDock});
  prefer(loadPreferences());
  showDocument(nullptr);
}

// The parts refer to one another, so they go in the reverse order of their making, before the widgets do.
MainWindow::~MainWindow() {
  m_kindDock->disconnect(this);
  // Hiding calls the members, so it must not wait until the widgets are destroyed.
  for (QDockWidget* dock : findChildren<QDockWidget*>()) dock->hide();
  hide();
  m_toolChoice->putAway();
  qDeleteAll(findChildren<QDialog*>(Qt::FindDirectChildrenOnly));  // preferences show the keys, which are a member
  for (const auto& [id, ui] : m_uis) ui->setDocument(nullptr);
}

void MainWindow::makeKinds(const KindSet& kinds) {
  const WindowContext parts{
      .window = this,
      .kinds = kinds.documents,
      .tabs = *m_tabs,
      .jobs = m_jobs,
      .pool = m_pool,
      .log = m_log,
      .viewport = *m_viewport,
      .services = m_services,
      .sound = m_sound,
      .tools = *m_tools,
      .fidelity = m_fidelity,
      .haptics = m_haptics,
      .touch = m_touch,
      .servoClock = m_servoClock,
      .spaceMouse = *m_spaceMouse,
      .saveAs = m_fileActions.saveAs(),
      .chooseTool = [this](const QString& id) { m_toolChoice->choose(id); },
      .openFile = [this](const QString& path) { openPaths({path}); },
      .openDocument = [this](OpenedFile opened) { return m_fileActions.loader().open(std::move(opened)); },
      .isPanelVisible = [this] { return m_kindDock->isVisible(); },
      .showPanel = &m_showPanel};
  for (const auto& [id, make] : kinds.windows) {
    auto made = make(parts);
    made->setParent(this);  // its actions are found below the window
    connect(made.get(), &KindUi::stateChanged, this, [this, from = made.get()] {
      if (from != ui()) return;
      m_viewSettings->setSectionFigures(ui()->sectionMeasurements());
      m_kindDock->setWindowTitle(ui()->panelTitle());
      m_properties->show();
      updateFigures();
      updateHints();
      updateCard();
    });
    m_toolChoice->add(*made);
    connect(made.get(), &KindUi::message, m_messages, &MessageBar::showMessage);
    m_uis.emplace(id, std::move(made));
  }
  // The most general kind, which is asked last whether it reads a file, comes first.
  const auto all = kinds.documents.all();
  for (auto kind = all.rbegin(); kind != all.rend(); ++kind) m_fileActions.add((*kind)->id(), *m_uis.at((*kind)->id()));
}

KindUi* MainWindow::ui() const {
  const DocumentTab* document = m_tabs->current();
  return document ? &document->ui : nullptr;
}

bool MainWindow::isSettled() const {
  return m_jobs.isIdle() &&
         std::all_of(m_uis.begin(), m_uis.end(), [](const auto& each) { return each.second->isSettled(); });
}

// A user who works in another program is not idle either.
void MainWindow::calibrateWhenIdle() {
  m_calibrator.beginWhenIdle([this] { return !isSettled() || m_haptics.isOpen() || !isActiveWindow(); });
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

// A space mouse is a node of the kernel, or behind the socket of spacenavd.
void MainWindow::openDevices() {
  m_haptics.takeUp();
  m_spaceMouse->watch({QStringLiteral("/dev"), QStringLiteral("/run")});
}

void MainWindow::prefer(const Preferences& preferences) {
  m_viewport->setNavigationPreset(presetOf(preferences.navigation));
  m_autosave.setInterval(preferences.autosaveSeconds);
  m_spaceMouse->setMotion(preferences.hasSpaceMouse, 0.01 * preferences.spaceMouseSpeed);
  m_sound.setVolume(0.01 * preferences.machineVolume);
  m_sound.setOn(preferences.hasMachineSound);
  updateHints();
}

QList<QDockWidget*> MainWindow::docks() const {
  return {m_documentsDock, m_historyDock, m_kindDock,     m_toolDock, m_propertiesDock,
          m_viewDock,      m_deviceDock,  m_fidelityDock, m_logDock,  m_statusDock};
}

// Qt makes the tab bars of docks by itself, and gives them no names.
void MainWindow::childEvent(QChildEvent* event) {
  QMainWindow::childEvent(event);
  auto* bar = event->polished() ? qobject_cast<QTabBar*>(event->child()) : nullptr;
  if (!bar || !bar->objectName().isEmpty()) return;
  bar->setObjectName(QStringLiteral("dockTabs"));
  bar->setAccessibleName(tr("Panels"));
  bar->setElideMode(Qt::ElideNone);  // tabs without space are scrolled to
  bar->setUsesScrollButtons(true);
  // Keys reach the panels by the strip; Qt keeps bars of folded panels outside the window, where a focus would be lost.
  bar->setFocusPolicy(Qt::ClickFocus);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (m_tabs->all().empty() && !m_jobs.isBusy(Job::Lane::Saving)) {
    saveLayout(*this);
    return event->accept();
  }
  event->ignore();
  // Later, as the last document may close while this event is dealt with, and a window that is closing ignores close().
  m_fileActions.requestCloseAll([this] { QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection); });
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
