// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/JobRunner.h"

#include "base/JobClock.h"
#include "document/Document.h"

#include <QThreadPool>
#include <algorithm>
#include <new>
#include <optional>
#include <utility>

namespace handwheel {

namespace {
constexpr int kPollMs = 20;
const Error kJobCancelled{ErrorCode::Cancelled, {}, {}, {}};

// Returns true if the later of two jobs waits for the earlier one.
bool waitsFor(const Job& later, const Job& earlier) {
  if (!later.resource.isEmpty() && later.resource == earlier.resource) return true;
  if (later.lane != earlier.lane || later.document != earlier.document) return false;
  const bool isByOwner = !later.document || later.lane == Job::Lane::Looking;
  return !isByOwner || later.owner == earlier.owner;
}

}  // namespace

struct JobRunner::Task {
  enum class Phase { Working, Abandoned, Ended };

  quint64 id = 0;
  Job job;
  QString documentName;
  JobState state;
  JobClock clock;      // for the window thread
  Job::Finish finish;  // written by the worker before done
  std::optional<Error> error;
  std::atomic<Phase> phase{Phase::Working};
  std::atomic<bool> done{false};

  void run(QThreadPool& pool) {
    try {
      if (phase == Phase::Working) finish = job.work(Progress(state));
    } catch (const std::bad_alloc&) {
      error = Error{ErrorCode::OutOfMemory, {}, {}, {}};
    } catch (const std::exception& thrown) {  // a defect of ours or of a library; the document is as it was
      error = Error{ErrorCode::LibraryFailed, {"C++", thrown.what()}, {}, {}};
    }
    job.work = nullptr;  // lets go of snapshots and caches before the window thread goes on
    if (phase.exchange(Phase::Ended) == Phase::Abandoned) pool.reserveThread();
    done.store(true, std::memory_order_release);
  }

  JobStatus status() { return {id, job.name, state.fraction, false, clock.seconds(state), documentName}; }
};

JobRunner::JobRunner(Policy policy, QThreadPool& pool, QObject* parent)
    : QObject(parent), m_policy(policy), m_pool(pool) {
  m_poll.setInterval(kPollMs);
  connect(&m_poll, &QTimer::timeout, this, &JobRunner::poll);
}

JobRunner::~JobRunner() {
  for (const auto& task : m_running) task->state.cancelled = true;
}

void JobRunner::start(Job job) {
  if (m_policy == Policy::Latest) {
    std::erase_if(m_waiting, [&](const Waiting& waiting) { return waitsFor(job, waiting.job); });
    for (const auto& task : m_running)
      if (waitsFor(job, task->job)) task->state.cancelled = true;
  }
  // The document may have been closed when its name is asked for.
  const QString documentName = job.document ? job.document->name() : QString();
  m_waiting.push_back({++m_lastId, std::move(job), documentName});
  startNext();
}

void JobRunner::cancel(quint64 id) {
  JobStatus status;
  const Document* document = nullptr;
  const auto note = [&](const Job& job, JobStatus of) {
    if (job.isUnasked || job.lane == Job::Lane::Saving) return;
    document = job.document;
    status = std::move(of);
  };
  for (const auto& task : m_running)
    if (task->id == id) note(task->job, task->status());
  for (const Waiting& waiting : m_waiting)
    if (waiting.id == id) note(waiting.job, {id, waiting.job.name, -1.0, true, 0, waiting.documentName});
  cancelThose([id](quint64 each, const Job&) { return each == id; });
  if (status.id != 0) emit cancelled(status, document);
}

bool JobRunner::cancelLatestOf(const Document* document) {
  quint64 latest = 0;
  const auto look = [&](quint64 id, const Job& job) {
    const bool isMeant = document && job.document == document && !job.isUnasked && job.lane != Job::Lane::Saving;
    if (isMeant) latest = std::max(latest, id);
  };
  for (const auto& task : m_running) look(task->id, task->job);
  for (const Waiting& waiting : m_waiting) look(waiting.id, waiting.job);
  if (latest != 0) cancel(latest);
  return latest != 0;
}

void JobRunner::cancelOf(const void* owner) {
  cancelThose([owner](quint64, const Job& job) { return job.owner == owner; });
}

// A job that goes on is no longer of this document: another one may have its address.
void JobRunner::forget(const Document* document) {
  const auto goesOn = [](const Job& job) { return job.outlivesDocument || job.lane == Job::Lane::Saving; };
  cancelThose([&](quint64, const Job& job) { return job.document == document && !goesOn(job); });
  const auto detach = [document](Job& job) {
    if (job.document == document) job.document = nullptr;
  };
  for (const auto& task : m_running) detach(task->job);
  for (Waiting& waiting : m_waiting) detach(waiting.job);
}

void JobRunner::cancelAll() {
  cancelThose([](quint64, const Job&) { return true; });
}

// A running job was asked to stop, and may take its time: only the latest job of its kind waits for it, and jobs that
// save.
void JobRunner::cancelThose(const IsMeant& isMeant) {
  std::vector<std::function<void(const Error&)>> failed;
  std::erase_if(m_waiting, [&](const Waiting& waiting) {
    const bool isGone = isMeant(waiting.id, waiting.job);
    if (isGone && m_policy == Policy::Queue) failed.push_back(waiting.job.failed);
    return isGone;
  });
  std::erase_if(m_running, [&](const std::shared_ptr<Task>& task) {
    if (!isMeant(task->id, task->job)) return false;
    task->state.cancelled = true;
    if (m_policy == Policy::Latest || task->job.lane == Job::Lane::Saving) return false;
    failed.push_back(task->job.failed);
    abandon(*task);
    return true;
  });
  for (const auto& each : failed) each(kJobCancelled);
  if (!failed.empty()) startNext();
}

// Its thread is no longer one of those that the pool may use, until it ends.
void JobRunner::abandon(Task& task) {
  auto working = Task::Phase::Working;
  if (task.phase.compare_exchange_strong(working, Task::Phase::Abandoned)) m_pool.releaseThread();
}

std::vector<JobStatus> JobRunner::jobs() const {
  std::vector<JobStatus> all;
  for (const auto& task : m_running) all.push_back(task->status());
  for (const Waiting& waiting : m_waiting)
    all.push_back({waiting.id, waiting.job.name, -1.0, true, 0, waiting.documentName});
  return all;
}

bool JobRunner::isBusyWithAny(const std::function<bool(const Job&)>& isMeant) const {
  return std::any_of(m_running.begin(), m_running.end(), [&](const auto& task) { return isMeant(task->job); }) ||
         std::any_of(m_waiting.begin(), m_waiting.end(), [&](const Waiting& each) { return isMeant(each.job); });
}

bool JobRunner::isBusy(Job::Lane lane) const {
  return isBusyWithAny([lane](const Job& job) { return job.lane == lane; });
}

bool JobRunner::isBusyWith(const Document* document) const {
  return isBusyWithAny([document](const Job& job) { return job.document == document; });
}

// Within a queue what came first is done first.
void JobRunner::startNext() {
  for (auto next = m_waiting.begin(); next != m_waiting.end();) {
    const bool isNext =
        std::none_of(m_running.begin(), m_running.end(),
                     [&](const auto& task) { return waitsFor(next->job, task->job); }) &&
        std::none_of(m_waiting.begin(), next, [&](const Waiting& first) { return waitsFor(next->job, first.job); });
    if (!isNext) {
      ++next;
      continue;
    }
    Waiting started = std::move(*next);
    next = m_waiting.erase(next);
    run(std::move(started));
  }
  m_running.empty() ? m_poll.stop() : m_poll.start();
  emit changed();
}

void JobRunner::run(Waiting next) {
  auto task = std::make_shared<Task>();
  task->id = next.id;
  task->job = std::move(next.job);
  task->documentName = std::move(next.documentName);
  m_running.push_back(task);
  task->job.starting();
  m_pool.start([task, &pool = m_pool] { task->run(pool); });
}

std::shared_ptr<JobRunner::Task> JobRunner::takeDone() {
  const auto done = std::find_if(m_running.begin(), m_running.end(),
                                 [](const auto& task) { return task->done.load(std::memory_order_acquire); });
  if (done == m_running.end()) return nullptr;
  const std::shared_ptr<Task> task = *done;
  m_running.erase(done);
  return task;
}

// The results of a cancelled job are discarded, whatever it still delivered; but a file that it wrote is written.
void JobRunner::end(const Task& task) {
  const bool hasOutcome = task.job.lane == Job::Lane::Saving && (task.error || task.finish);
  if (task.state.cancelled && !hasOutcome) {
    task.job.failed(kJobCancelled);
  } else if (task.error) {
    task.job.failed(*task.error);
  } else if (task.finish) {
    task.finish();
  }
}

void JobRunner::poll() {
  if (!m_running.empty()) emit progressed();
  bool isAnyDone = false;
  while (const std::shared_ptr<Task> task = takeDone()) {
    isAnyDone = true;
    end(*task);
  }
  if (isAnyDone) startNext();
}

}  // namespace handwheel
