// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "base/Progress.h"

#include <QObject>
#include <QTimer>
#include <deque>
#include <functional>
#include <memory>

class QThreadPool;

namespace handwheel {

// Long work for a worker thread. It sees only what it captured by value (snapshots), and returns what is to be done
// with its result on the window thread.
struct Job {
  using Finish = std::function<void()>;

  QString name;
  std::function<Finish(Progress)> work;
  // Instead of the finish, on the window thread: Cancelled, OutOfMemory, or LibraryFailed for what else was thrown.
  std::function<void(const Error&)> failed = [](const Error&) {};
  const void* owner = nullptr;  // with which it is cancelled: a document
};

// Runs jobs one after another. Everything here is called and emitted on the window thread.
class JobRunner : public QObject {
  Q_OBJECT

 public:
  enum class Policy {
    Queue,   // each job is done; a cancelled one is abandoned at once, even where its library cannot be interrupted
    Latest,  // a new job replaces the present one, and starts when that has let go of what both use
  };

  // The pool bounds the number of abandoned workers.
  JobRunner(Policy policy, QThreadPool& pool, QObject* parent = nullptr);
  ~JobRunner() override;

  void start(Job job);
  void cancel();
  void cancelOf(const void* owner);  // all that it owns
  bool isIdle() const { return !m_running && m_waiting.empty(); }

 signals:
  void started(const QString& name);
  void progressed(double fraction);
  void finished();  // nothing runs and nothing waits

 private:
  struct Task;
  void abandonRunning();
  void startNext();
  void poll();

  Policy m_policy;
  QThreadPool& m_pool;
  std::shared_ptr<Task> m_running;
  std::deque<Job> m_waiting;
  QTimer m_poll;
};

}  // namespace handwheel
