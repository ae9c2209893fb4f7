// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/LogModel.h"
#include "window/FileActions.h"
#include "window/HolePreview.h"
#include "window/JobRunner.h"
#include "window/RecentFiles.h"
#include "window/RepairActions.h"
#include "window/RepairJobs.h"
#include "window/Selection.h"
#include "window/SelfIntersectionSearch.h"

#include <QMainWindow>
#include <QUndoGroup>

class QLabel;
class QStackedWidget;

namespace handwheel {

class DefectsPanel;
class DocumentScene;
class DocumentsPanel;
class DocumentTabs;
class HintBar;
class JobBar;
class MessageBar;
class NextStepCard;
class StartPage;
class ViewActions;
class Viewport;

// Puts the parts of the window together and connects them. Decisions are made in the parts.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  // The pool runs all jobs; it outlives the window.
  explicit MainWindow(QThreadPool& pool);
  ~MainWindow() override;

  void openPaths(const QStringList& paths) { m_fileActions.openPaths(paths); }
  // Nothing is running that will still change what the window shows.
  bool isSettled() const;

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildCentre();
  void buildDocks();
  void buildStatusBar();
  void buildMenus();
  void buildToolBars();
  void connectDocuments();
  void connectSelection();
  void connectJobs();
  void connectStartPage();

  void showDocument(OpenDocument* document);
  void updateTitle();
  void updateFigures();
  void updateCard();
  void updateHints();
  void showDefects();

  JobRunner m_jobs;
  LogModel m_log;
  RecentFiles m_recent;
  QUndoGroup m_undo;
  Selection m_selection;
  HolePreview m_preview;
  SelfIntersectionSearch m_search;
  DocumentTabs* m_tabs;
  FileActions m_fileActions;
  RepairJobs m_repairJobs;
  RepairActions m_repairActions;
  QAction m_showDefects;
  QAction m_quit;

  Viewport* m_viewport;
  ViewActions* m_viewActions;
  DefectsPanel* m_defects;
  DocumentsPanel* m_documents;
  DocumentScene* m_scene;
  StartPage* m_start;
  QStackedWidget* m_stack;
  MessageBar* m_messages;
  NextStepCard* m_card;
  HintBar* m_hints;
  JobBar* m_jobBar;
  QLabel* m_figures;
  QLabel* m_unit;
  QDockWidget* m_documentsDock;
  QDockWidget* m_historyDock;
  QDockWidget* m_defectsDock;
  QDockWidget* m_logDock;
};

}  // namespace handwheel
