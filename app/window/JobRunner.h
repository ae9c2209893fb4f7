// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "panels/JobStatus.h"

#include <QObject>
#include <QTimer>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

class QThreadPool;

namespace handwheel {

// A long task for a worker thread. It uses only values that it captured by copy (snapshots), and returns a function
// that applies its result on the window thread.
struct Job {
  using Finish = std::function<void()>;
  // Jobs of different lanes run in parallel, so that saving does not wait for the work on other documents.
  enum class Lane { Work, Saving };

  QString name;
  std::function<Finish(Progress)> work;
  // The function that is called on the window thread instead of the finish function if the job fails. Errors:
  // Cancelled, OutOfMemory, or LibraryFailed for any other exception.
  std::function<void(const Error&)> failed = [](const Error&) {};
  const void* owner = nullptr;  // the document of the job; cancelOf() cancels all its jobs
  Lane lane = Lane::Work;
  // The function that is called on the window thread just before the job runs. It can read the results of earlier jobs.
  std::function<void()> starting = [] {};
};

// Runs jobs on worker threads; the jobs of a lane run one after another. All functions must be called, and all signals
// are emitted, on the window thread.
class JobRunner : public QObject {
  Q_OBJECT

 public:
  enum class Policy {
    Queue,   // Every job runs. A cancelled job is abandoned at once, even if its library cannot be interrupted. Only a
             // job that saves is waited for, because it may have written its file
    Latest,  // A new job replaces the present one. It starts when the present job has released the data that both jobs
             // use
  };

  // pool: the threads of the jobs. Its size limits the number of abandoned jobs that still run.
  JobRunner(Policy policy, QThreadPool& pool, QObject* parent = nullptr);
  ~JobRunner() override;

  void start(Job job);
  void cancel(quint64 id);           // an id from jobs(); does nothing if the job has ended
  void cancelOf(const void* owner);  // cancels all jobs of this owner
  void cancelAll();
  bool cancelRunning(Job::Lane lane);  // returns false if no job of the lane is running
  bool isBusy(Job::Lane lane) const;   // returns true if a job of the lane runs or waits
  bool isIdle() const { return m_running.empty() && m_waiting.empty(); }
  // Returns the running jobs, then the waiting ones, each in the order in which they were started.
  std::vector<JobStatus> jobs() const;

 signals:
  void changed();     // a job was added, started or ended
  void progressed();  // the progress of a job changed

 private:
  struct Waiting {
    quint64 id;
    Job job;
  };
  struct Task;
  void cancelThose(const std::function<bool(quint64 id, const Job& job)>& isMeant);
  bool isFree(Job::Lane lane) const;
  void startNext();
  std::shared_ptr<Task> takeDone();
  static void end(const Task& task);
  void poll();

  Policy m_policy;
  QThreadPool& m_pool;
  std::vector<std::shared_ptr<Task>> m_running;  // at most one per lane
  std::deque<Waiting> m_waiting;
  quint64 m_lastId = 0;
  QTimer m_poll;
};

}  // namespace handwheel
