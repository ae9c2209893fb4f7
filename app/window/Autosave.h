// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "document/Recovery.h"
#include "document/RecoveryLeftovers.h"
#include "panels/MessageBar.h"
#include "window/JobRunner.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <map>
#include <memory>
#include <set>

namespace handwheel {

class DocumentTabs;
class FileLoader;
class LogModel;
class WindowServices;
struct OpenDocument;

// Keeps what was not saved: a document that was changed is written to the recovery folder within the interval, and
// leaves it when it is saved or closed. What a session that was killed left there is offered at the next start, until
// it is recovered or discarded.
class Autosave : public QObject {
  Q_OBJECT

 public:
  Autosave(DocumentTabs& tabs, FileLoader& loader, LogModel& log, WindowServices& services, QObject* parent = nullptr);

  void setInterval(int seconds);  // 0: never
  void offerLeftovers();

 signals:
  void message(const handwheel::Message& message);

 private:
  void follow(OpenDocument* document);
  void changed();
  void saveAll();
  void save(OpenDocument* document);
  void tellFailure(OpenDocument* document, const QString& name, const Error& error);
  void offer(const std::shared_ptr<const Leftovers>& leftovers);
  void offerDamaged(const std::shared_ptr<const Leftovers>& leftovers);
  void recover(const std::shared_ptr<const Leftovers>& leftovers);
  void discard(const Leftovers& leftovers);

  DocumentTabs& m_tabs;
  FileLoader& m_loader;
  LogModel& m_log;
  WindowServices& m_services;
  QThreadPool m_pool;  // of its own: long jobs must not delay it
  JobRunner m_jobs;
  QTimer m_timer;  // runs from the first change that is in no autosave
  Need m_need;     // as long as that is so
  std::shared_ptr<RecoverySession> m_session;
  std::map<const OpenDocument*, std::uint64_t> m_keys;
  std::uint64_t m_lastKey = 0;
  std::set<const OpenDocument*> m_failing;  // whose last autosave failed
};

}  // namespace handwheel
