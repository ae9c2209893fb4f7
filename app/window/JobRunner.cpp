// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/JobRunner.h"

#include "base/JobClock.h"

#include <QThreadPool>
#include <algorithm>
#include <new>
#include <optional>
#include <utility>

namespace handwheel {

namespace {
constexpr int kPollMs = 20;
const Error kJobCancelled{ErrorCode::Cancelled, {}, {}, {}};
}  // namespace

struct JobRunner::Task {
  quint64 id = 0;
  Job job;
  JobState state;
  JobClock clock;      // for the window thread
  Job::Finish finish;  // written by the worker before done
  std::optional<Error> error;
  std::atomic<bool> done{false};

  void run() {
    try {
      finish = job.work(Progress(state));
    } catch (const std::bad_alloc&) {
      error = Error{ErrorCode::OutOfMemory, {}, {}, {}};
    } catch (const std::exception& thrown) {  // a defect of ours or of a library; the document is as it was
      error = Error{ErrorCode::LibraryFailed, {"C++", thrown.what()}, {}, {}};
    }
    job.work = nullptr;  // lets go of snapshots and caches before the window thread goes on
    done.store(true, std::memory_order_release);
  }
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
    m_waiting.clear();
    for (const auto& task : m_running) task->state.cancelled = true;
  }
  m_waiting.push_back({++m_lastId, std::move(job)});
  startNext();
}

void JobRunner::cancel(quint64 id) {
  cancelThose([id](quint64 each, const Job&) { return each == id; });
}

void JobRunner::cancelOf(const void* owner) {
  cancelThose([owner](quint64, const Job& job) { return job.owner == owner; });
}

void JobRunner::cancelAll() {
  cancelThose([](quint64, const Job&) { return true; });
}

bool JobRunner::cancelRunning(Job::Lane lane) {
  const auto found =
      std::find_if(m_running.begin(), m_running.end(), [lane](const auto& task) { return task->job.lane == lane; });
  if (found == m_running.end()) return false;
  cancel((*found)->id);
  return true;
}

// A running job was asked to stop, and may take its time: only the latest job of its kind waits for it, and jobs that
// save.
void JobRunner::cancelThose(const std::function<bool(quint64 id, const Job& job)>& isMeant) {
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
    return true;
  });
  for (const auto& each : failed) each(kJobCancelled);
  if (!failed.empty()) startNext();
}

std::vector<JobStatus> JobRunner::jobs() const {
  std::vector<JobStatus> all;
  for (const auto& task : m_running)
    all.push_back({task->id, task->job.name, task->state.fraction, false, task->clock.seconds(task->state)});
  for (const Waiting& waiting : m_waiting) all.push_back({waiting.id, waiting.job.name, -1.0, true});
  return all;
}

bool JobRunner::isBusy(Job::Lane lane) const {
  return !isFree(lane) || std::any_of(m_waiting.begin(), m_waiting.end(),
                                      [lane](const Waiting& waiting) { return waiting.job.lane == lane; });
}

bool JobRunner::isFree(Job::Lane lane) const {
  return std::none_of(m_running.begin(), m_running.end(), [lane](const auto& task) { return task->job.lane == lane; });
}

void JobRunner::startNext() {
  for (auto next = m_waiting.begin(); next != m_waiting.end();) {
    if (!isFree(next->job.lane)) {
      ++next;
      continue;
    }
    auto task = std::make_shared<Task>();
    task->id = next->id;
    task->job = std::move(next->job);
    next = m_waiting.erase(next);
    m_running.push_back(task);
    task->job.starting();
    m_pool.start([task] { task->run(); });
  }
  m_running.empty() ? m_poll.stop() : m_poll.start();
  emit changed();
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
