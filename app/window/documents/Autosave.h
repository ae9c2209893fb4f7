// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "document/Snapshot.h"
#include "document/recovery/OrphanedAutosaves.h"
#include "document/recovery/Recovery.h"
#include "panels/MessageBar.h"
#include "window/JobRunner.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <chrono>
#include <map>
#include <memory>

namespace handwheel {

class DocumentTabs;
class FileLoader;
class LogModel;
class ToolHost;
class WindowServices;
struct DocumentTab;

// Saves modified documents to the recovery folder. A document is saved soon after each edit, so that no finished edit
// is lost if the program is killed; the unfinished work of a tool is saved at intervals. Documents that take long to
// save are saved less often, but at least once in the interval. The recovery file is removed when its document is
// saved or closed. The files of a killed session are offered at the next start, until they are recovered or discarded.
// If the killed session has not yet released its lock, its files are offered soon after the start.
class Autosave : public QObject {
  Q_OBJECT

 public:
  Autosave(DocumentTabs& tabs, FileLoader& loader, LogModel& log, WindowServices& services, QObject* parent = nullptr);

  void setInterval(int seconds);  // longest interval between autosaves; 0: no autosave
  // Enables saving the unfinished work of the tools of a window.
  void watch(ToolHost& tools);
  void offerRecovery();

 signals:
  void message(const handwheel::Message& message);

 private:
  void follow(DocumentTab* document);
  // A document whose changes are saved.
  struct Followed {
    std::uint64_t key = 0;
    std::unique_ptr<QTimer> timer;      // runs from the first change after an autosave
    std::chrono::milliseconds cost{0};  // duration of the last autosave, wall-clock time
    bool isFailing = false;             // the last autosave failed
  };

  void changed(DocumentTab* document);
  std::chrono::milliseconds pauseAfter(std::chrono::milliseconds cost) const;
  void need();
  void rest();
  void saveChanged(DocumentTab* document);
  void saveWork();
  bool hasWorkGoingOn() const;
  void save(DocumentTab* document, SnapshotPointer content);
  bool isFollowed(const DocumentTab* document, std::uint64_t key) const;
  void noteCost(DocumentTab* document, std::chrono::milliseconds cost);
  void reportFailure(DocumentTab* document, const QString& name, const Error& error);
  void offer(OrphanedAutosaves found);
  void lookAgain(std::vector<std::filesystem::path> sessions, std::chrono::milliseconds pause);
  void askBeforeDiscarding(const std::shared_ptr<const OrphanedAutosaves>& orphans);
  void offer(const std::shared_ptr<const OrphanedAutosaves>& orphans);
  void offerDamaged(const std::shared_ptr<const OrphanedAutosaves>& orphans);
  void recover(const std::shared_ptr<const OrphanedAutosaves>& orphans);
  void discard(const OrphanedAutosaves& orphans);

  DocumentTabs& m_tabs;
  FileLoader& m_loader;
  LogModel& m_log;
  WindowServices& m_services;
  ToolHost* m_tools = nullptr;
  QThreadPool m_pool;  // separate pool, so that long jobs do not delay autosaves
  JobRunner m_jobs;
  QTimer m_timer;        // timer for unfinished work, with the longest interval
  ServiceHandle m_need;  // held while there is something to save
  std::shared_ptr<RecoverySession> m_session;
  std::map<const DocumentTab*, Followed> m_followed;
  std::uint64_t m_lastKey = 0;
};

}  // namespace handwheel
