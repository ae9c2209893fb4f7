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

class Document;

// Number of threads of the pool in which jobs run. It is no limit in practice: jobs wait for the jobs of their own
// document (JobRunner), never for a thread.
constexpr int kJobThreads = 64;

// A long task for a worker thread. It uses only values that it captured by copy (snapshots), and returns a function
// that applies its result on the window thread.
struct Job {
  using Finish = std::function<void()>;
  // Jobs of different lanes run in parallel, so that neither a save nor a search delays a change.
  enum class Lane {
    Work,     // Changes the document, or opens one
    Looking,  // Looks at a snapshot of the document, and changes nothing in it
    Saving
  };

  QString name;
  std::function<Finish(Progress)> work;
  // The function that is called on the window thread instead of the finish function if the job fails. Errors:
  // Cancelled, OutOfMemory, or LibraryFailed for any other exception.
  std::function<void(const Error&)> failed = [](const Error&) {};
  const Document* document = nullptr;  // the document of the job; forget() cancels all its jobs. Null: it has none
  const void* owner = nullptr;         // the part of the window that can cancel its own jobs by cancelOf()
  Lane lane = Lane::Work;
  // The function that is called on the window thread just before the job runs. It can read the results of earlier jobs.
  std::function<void()> starting = [] {};
  QString resource = {};   // a file that the job writes, or a device: only one job at a time may use it. May be empty
  bool isUnasked = false;  // started by the program for its display: Esc leaves it, and its cancelling is not announced
  // The job goes on when its document is closed, because its result is a document of its own.
  bool outlivesDocument = false;
};

// Runs jobs on worker threads. A job waits only for earlier jobs of its own queue, and for those with the same
// resource. The queue is that of its document and lane; the owners of Lane::Looking have one each, and so have the
// owners of jobs without a document. All functions must be called, and all signals are emitted, on the window thread.
class JobRunner : public QObject {
  Q_OBJECT

 public:
  enum class Policy {
    Queue,   // Every job runs. A cancelled job is abandoned at once, even if its library cannot be interrupted. Only a
             // job that saves is waited for, because it may have written its file
    Latest,  // A new job replaces the present one of its queue. It starts when the present job has ended, so that
             // they can use the same data
  };

  // pool: the threads of the jobs. An abandoned job does not count among its threads.
  JobRunner(Policy policy, QThreadPool& pool, QObject* parent = nullptr);
  ~JobRunner() override;

  void start(Job job);
  // Cancels a job for the user. The function does nothing if the job has ended. id: an id from jobs().
  void cancel(quint64 id);
  // Cancels the latest job for the user that was asked for in this document, unless it saves. Returns false if there is
  // none.
  bool cancelLatestOf(const Document* document);
  void cancelOf(const void* owner);  // cancels all jobs of this owner
  // Cancels the jobs of a document that is about to close, except those that save or outlive their document.
  void forget(const Document* document);
  void cancelAll();
  bool isBusy(Job::Lane lane) const;  // returns true if a job of the lane runs or waits
  bool isBusyWith(const Document* document) const;
  bool isIdle() const { return m_running.empty() && m_waiting.empty(); }
  // Returns the running jobs, then the waiting ones, each in the order in which they were started.
  std::vector<JobStatus> jobs() const;

 signals:
  void changed();     // a job was added, started or ended
  void progressed();  // the progress of a job changed
  // Emitted when the user has cancelled a job that was asked for and does not save; those that save report their end
  // themselves. document: null if the job had none.
  void cancelled(const handwheel::JobStatus& job, const handwheel::Document* document);

 private:
  struct Waiting {
    quint64 id;
    Job job;
    QString documentName;
  };
  struct Task;
  using IsMeant = std::function<bool(quint64 id, const Job& job)>;
  void cancelThose(const IsMeant& isMeant);
  bool isBusyWithAny(const std::function<bool(const Job&)>& isMeant) const;
  void startNext();
  void run(Waiting next);
  void abandon(Task& task);
  std::shared_ptr<Task> takeDone();
  static void end(const Task& task);
  void poll();

  Policy m_policy;
  QThreadPool& m_pool;
  std::vector<std::shared_ptr<Task>> m_running;  // at most one per queue
  std::deque<Waiting> m_waiting;
  quint64 m_lastId = 0;
  QTimer m_poll;
};

}  // namespace handwheel
