// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Assembly of the main window: centre, docks and status bar.
#include "controls/ScrolledPanel.h"
#include "controls/StatusPanel.h"
#include "panels/DockTitle.h"
#include "panels/DocumentsPanel.h"
#include "panels/HintBar.h"
#include "panels/JobBar.h"
#include "panels/LogPanel.h"
#include "panels/MessageBar.h"
#include "panels/StartPage.h"
#include "panels/SuggestionCard.h"
#include "viewport/Viewport.h"
#include "window/MainWindow.h"
#include "window/PanelToggle.h"
#include "window/SlowdownLabel.h"
#include "window/ViewActions.h"
#include "window/ViewFocus.h"
#include "window/ViewSettings.h"
#include "window/documents/DocumentProperties.h"
#include "window/documents/DocumentTabs.h"
#include "window/fidelity/CalibrationRow.h"
#include "window/fidelity/FidelityPanel.h"
#include "window/fidelity/FrameTiming.h"
#include "window/haptics/DevicePointer.h"
#include "window/haptics/DeviceView.h"
#include "window/haptics/HapticFidelity.h"
#include "window/haptics/RecordingIndicator.h"
#include "window/haptics/SessionDevicePanel.h"
#include "window/haptics/SessionRecordingsPage.h"
#include "window/haptics/SpaceMouseNavigation.h"
#include "window/haptics/TickTiming.h"
#include "window/haptics/TouchPage.h"
#include "window/tools/ToolChoice.h"
#include "window/tools/ToolHost.h"
#include "window/tools/ToolPanel.h"

#include <QDockWidget>
#include <QLabel>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolButton>
#include <QUndoView>
#include <QVBoxLayout>

namespace handwheel {

namespace {

QDockWidget* addDock(MainWindow& window, Qt::DockWidgetArea area, const char* name, const QString& title,
                     QWidget* content, const char* iconName) {
  auto* dock = new QDockWidget(title, &window);
  dock->setObjectName(QString::fromLatin1(name));
  dock->setAccessibleName(title);
  dock->setWidget(content);
  dock->setTitleBarWidget(new DockTitle(dock));
  new PanelToggle(dock, QString::fromLatin1(iconName));
  window.addDockWidget(area, dock);
  return dock;
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
  column->addWidget(m_stack, 1);
  m_messages->lieOver(m_stack);  // nothing that is looked at or pointed to moves when a message comes or goes
  setCentralWidget(centre);
  m_viewActions = new ViewActions(*m_viewport, this);
  new ViewFocus(*this, *m_viewport, this);
  m_deviceView = new DeviceView(m_haptics, *m_viewport, this);
  m_spaceMouse = new SpaceMouseNavigation(m_haptics, *m_viewport, m_pool, this);
  m_toolPanel = new ToolPanel(this);
  m_tools = new ToolHost(*m_viewport, *m_toolPanel, m_services.needs(), this);
  new HapticFidelity(m_fidelity, m_haptics, m_touch, this);
  new DevicePointer(m_haptics, *m_viewport, *m_tools, m_touch);
  m_toolChoice = new ToolChoice(*m_tools, this);
  m_card = new SuggestionCard(m_viewport);
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
  m_history = new QUndoView(&m_undo, this);
  m_history->setObjectName(QStringLiteral("historyView"));
  m_history->setAccessibleName(tr("History"));
  m_history->setWordWrap(true);  // a step may say the name of a file
  m_history->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_history->setResizeMode(QListView::Adjust);
  m_kindPanels = new QStackedWidget(this);
  for (const auto& [id, each] : m_uis) m_kindPanels->addWidget(each->panel());
  m_documentsDock = addDock(*this, Qt::LeftDockWidgetArea, "documentsDock", tr("Documents"), m_documents, "documents");
  m_historyDock = addDock(*this, Qt::LeftDockWidgetArea, "historyDock", tr("History"), m_history, "history");
  m_kindDock = addDock(*this, Qt::RightDockWidgetArea, "kindDock", {}, m_kindPanels, "file");
  m_toolDock = addDock(*this, Qt::RightDockWidgetArea, "toolDock", tr("Tool"), m_toolPanel, "tool-settings");
  auto* properties = new PropertyList(this);
  properties->setEmptyText(tr("No document is open."));
  m_properties = new DocumentProperties(*properties, this);
  m_propertiesDock =
      addDock(*this, Qt::RightDockWidgetArea, "propertiesDock", tr("Properties"), properties, "properties");
  auto* view = new PropertyList(this);
  m_viewSettings = new ViewSettings(*view, *m_viewport, this);
  m_viewDock = addDock(*this, Qt::RightDockWidgetArea, "viewDock", tr("View"), view, "view-iso");
  auto* fidelity = new FidelityPanel(m_fidelity, this);
  fidelity->addBelow(new TickTiming(m_haptics, m_fidelity, fidelity));
  fidelity->addBelow(new FrameTiming(*m_viewport, m_fidelity, fidelity));
  fidelity->addBelow(new CalibrationRow(m_fidelity, m_calibrator, fidelity));
  auto* scrolledFidelity = new ScrolledPanel(fidelity, ScrolledPanel::Directions::Vertical, this);
  m_fidelityDock = addDock(*this, Qt::LeftDockWidgetArea, "fidelityDock", tr("Fidelity"), scrolledFidelity, "fidelity");
  tabifyDockWidget(m_historyDock, m_fidelityDock);
  m_historyDock->raise();
  tabifyDockWidget(m_kindDock, m_toolDock);
  tabifyDockWidget(m_toolDock, m_propertiesDock);
  tabifyDockWidget(m_propertiesDock, m_viewDock);
  // Most have no device: who plugs one in finds it in the menu.
  auto* device = new SessionDevicePanel(m_haptics, this);
  device->addPage(new TouchPage(m_haptics, device), tr("Touch"));
  device->addPage(new SessionRecordingsPage(m_recordings, m_haptics, device), tr("Record"));
  connect(m_spaceMouse, &SpaceMouseNavigation::changed, device,
          [this, device] { device->setSpaceMice(m_spaceMouse->names()); });
  m_deviceDock = addDock(*this, Qt::RightDockWidgetArea, "deviceDock", tr("Device"), device, "device");
  tabifyDockWidget(m_viewDock, m_deviceDock);
  m_deviceDock->hide();
  m_kindDock->raise();
  auto* status = new StatusPanel(this);
  status->setSource([this] { return m_services.status(); });
  m_statusDock = addDock(*this, Qt::BottomDockWidgetArea, "statusDock", tr("Status"), status, "status");
  m_logDock = addDock(*this, Qt::BottomDockWidgetArea, "logDock", tr("Log"), new LogPanel(&m_log, this), "log");
  for (QDockWidget* dock : docks()) dock->installEventFilter(m_tools);  // one that floats is a window of its own
  connect(m_kindDock, &QDockWidget::visibilityChanged, this, &MainWindow::updateCard);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  resizeDocks({m_documentsDock, m_kindDock}, {216, 280}, Qt::Horizontal);
  resizeDocks({m_documentsDock, m_historyDock}, {300, 300}, Qt::Vertical);
  resizeDocks({m_logDock}, {176}, Qt::Vertical);
}

void MainWindow::buildStatusBar() {
  m_hints = new HintBar(this);
  m_jobBar = new JobBar(this);
  auto* slowdown = new SlowdownLabel(m_services.simulation(), this);
  m_figures = new QLabel(this);
  m_figures->setObjectName(QStringLiteral("figures"));
  m_unit = new QLabel(this);
  m_unit->setObjectName(QStringLiteral("badge"));
  auto* log = new QToolButton(this);
  log->setObjectName(QStringLiteral("logButton"));
  log->setDefaultAction(m_logDock->findChild<PanelToggle*>());
  log->setAccessibleName(tr("Log"));
  log->setIconSize({16, 16});
  auto* recording = new RecordingIndicator(m_haptics, this);
  connect(recording, &QToolButton::clicked, this, [this] {
    auto* device = m_deviceDock->findChild<SessionDevicePanel*>();
    device->showPage(device->findChild<SessionRecordingsPage*>());
    m_deviceDock->show();
    m_deviceDock->raise();
  });
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(m_hints, 1);
  for (QWidget* widget : std::initializer_list<QWidget*>{m_jobBar, slowdown, recording, m_figures, m_unit, log}) {
    statusBar()->addPermanentWidget(widget);
  }
}

}  // namespace handwheel
