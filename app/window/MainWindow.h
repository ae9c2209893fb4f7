// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "audio/MachineSound.h"
#include "controls/ShortcutModel.h"
#include "panels/LogModel.h"
#include "window/JobRunner.h"
#include "window/WindowServices.h"
#include "window/documents/Autosave.h"
#include "window/documents/CopyActions.h"
#include "window/documents/FileActions.h"
#include "window/documents/RecentFiles.h"
#include "window/documents/Thumbnails.h"
#include "window/fidelity/BenchmarkRunner.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/haptics/HapticSceneBuilder.h"
#include "window/haptics/HapticSession.h"
#include "window/haptics/Recordings.h"
#include "window/kinds/KindMenus.h"
#include "window/kinds/KindUi.h"

#include <QMainWindow>
#include <QTimer>
#include <QUndoGroup>

class QLabel;
class QStackedWidget;
class QUndoView;
class QToolBar;

namespace handwheel {

class CommandPalette;
class DeviceView;
class DocumentProperties;
class DocumentsPanel;
class DocumentTabs;
class HintBar;
class JobBar;
class MessageBar;
class SuggestionCard;
class PropertyList;
class StartPage;
class StatusPanel;
class ToolChoice;
class ToolHost;
class ToolPanel;
class ViewActions;
class SpaceMouseNavigation;
class ViewSettings;
class Viewport;
struct Preferences;

// The main window, which creates its parts and connects them. The parts contain the logic.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  using Drivers = std::vector<std::unique_ptr<DeviceDriver>>;
  // pool: runs all jobs; it must outlive the window. drivers: the built-in device drivers, in addition to those of
  // plugins.
  MainWindow(QThreadPool& pool, const KindSet& kinds, Drivers drivers = {});
  ~MainWindow() override;

  void openPaths(const QStringList& paths) { m_fileActions.openPaths(paths); }
  // Offers to recover documents of a session that was killed. To be called at the start of the program.
  void offerRecovery() { m_autosave.offerRecovery(); }
  // Opens the haptic device that was in use last, and each space mouse. To be called at the start of the program.
  void openDevices();
  // Calibrates the accuracy settings on this machine when the user is idle, unless they are already calibrated. To be
  // called at the start of the program.
  void calibrateWhenIdle();
  // Returns true if nothing is running that will still change the display of the window.
  bool isSettled() const;

 protected:
  void childEvent(QChildEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildCentre();
  void buildDocks();
  void buildStatusBar();
  void buildMenus();
  void buildToolBars();
  void addSearch();
  void placeKinds();
  void connectDocuments();
  void connectDocumentsPanel();
  void connectMessages();
  void connectTools();
  void connectRecordings();
  void connectJobs();
  void reportCancelled(const JobStatus& job, const Document* document);
  void connectStartPage();

  KindUi* ui() const;  // interface of the present document's kind; null if no document is open
  void makeKinds(const KindSet& kinds);
  void showDocument(DocumentTab* document);
  void storePicture();
  void updateTitle();
  void updateFigures();
  void updateCard();
  void updateHints();
  std::vector<Hint> hints();  // the present mouse and key bindings
  void showPanel();
  void showPreferences();
  void prefer(const Preferences& preferences);
  QList<QDockWidget*> docks() const;  // returns the docks in the order of the menu

  JobRunner m_jobs;
  LogModel m_log;
  RecentFiles m_recent;
  Thumbnails m_thumbnails;
  QUndoGroup m_undo;
  WindowServices m_services;
  MachineSound m_sound;
  FidelityChoice m_fidelity;
  BenchmarkRunner m_calibrator;
  MonotonicClock m_servoClock;
  HapticSession m_haptics;
  HapticSceneBuilder m_touch;
  Recordings m_recordings;
  KindUis m_uis;
  QThreadPool& m_pool;
  ShortcutModel m_keys;
  DocumentTabs* m_tabs;
  FileActions m_fileActions;
  CopyActions m_copies;
  Autosave m_autosave;
  QAction m_showPanel;
  QAction m_quit;
  QTimer m_pictureTimer;  // delays the thumbnail until the current document is drawn and the camera rests
  DocumentTab* m_shown = nullptr;

  Viewport* m_viewport;
  ViewActions* m_viewActions;
  DocumentsPanel* m_documents;
  QUndoView* m_history;
  StartPage* m_start;
  QStackedWidget* m_stack;
  QStackedWidget* m_kindPanels;
  QToolBar* m_kindBar;
  MessageBar* m_messages;
  SuggestionCard* m_card;
  HintBar* m_hints;
  JobBar* m_jobBar;
  QLabel* m_figures;
  QLabel* m_unit;
  DocumentProperties* m_properties;
  ViewSettings* m_viewSettings;
  ToolPanel* m_toolPanel;
  ToolHost* m_tools;
  DeviceView* m_deviceView;
  SpaceMouseNavigation* m_spaceMouse;
  ToolChoice* m_toolChoice;
  std::unique_ptr<KindMenus> m_kindMenus;
  CommandPalette* m_palette;
  QDockWidget* m_documentsDock;
  QDockWidget* m_historyDock;
  QDockWidget* m_kindDock;
  QDockWidget* m_toolDock;
  QDockWidget* m_propertiesDock;
  QDockWidget* m_viewDock;
  QDockWidget* m_deviceDock;
  QDockWidget* m_fidelityDock;
  QDockWidget* m_logDock;
  QDockWidget* m_statusDock;
};

}  // namespace handwheel
