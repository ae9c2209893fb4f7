// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/JobRunner.h"

#include <QThreadPool>
#include <new>
#include <optional>
#include <utility>

namespace handwheel {

namespace {
constexpr int kPollMs = 20;
const Error kCancelled{ErrorCode::Cancelled, {}, {}, {}};
}  // namespace

struct JobRunner::Task {
  Job job;
  JobState state;
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
  if (m_running) m_running->state.cancelled = true;
}

void JobRunner::start(Job job) {
  if (m_policy == Policy::Latest) {
    m_waiting.clear();
    if (m_running) m_running->state.cancelled = true;
  }
  m_waiting.push_back(std::move(job));
  if (!m_running) startNext();
}

void JobRunner::cancel() {
  const std::deque<Job> waiting = std::exchange(m_waiting, {});
  if (!m_running) return;
  m_running->state.cancelled = true;
  if (m_policy == Policy::Latest) return;
  abandonRunning();
  for (const Job& job : waiting) job.failed(kCancelled);
  if (!m_running) startNext();
}

void JobRunner::cancelOf(const void* owner) {
  std::vector<Job> cancelled;
  for (auto job = m_waiting.begin(); job != m_waiting.end();) {
    if (job->owner == owner) cancelled.push_back(std::move(*job));
    job = job->owner == owner ? m_waiting.erase(job) : job + 1;
  }
  for (const Job& job : cancelled) job.failed(kCancelled);
  if (!m_running || m_running->job.owner != owner) return;
  m_running->state.cancelled = true;
  if (m_policy == Policy::Latest) return;
  abandonRunning();
  if (!m_running) startNext();
}

// It has been told to stop, and may take its time.
void JobRunner::abandonRunning() {
  const std::shared_ptr<Task> abandoned = std::exchange(m_running, nullptr);
  abandoned->job.failed(kCancelled);
}

void JobRunner::startNext() {
  if (m_waiting.empty()) {
    m_poll.stop();
    emit finished();
    return;
  }
  m_running = std::make_shared<Task>();
  m_running->job = std::move(m_waiting.front());
  m_waiting.pop_front();
  emit started(m_running->job.name);
  m_pool.start([task = m_running] { task->run(); });
  m_poll.start();
}

void JobRunner::poll() {
  if (!m_running) return;
  if (!m_running->done.load(std::memory_order_acquire)) {
    emit progressed(m_running->state.fraction);
    return;
  }
  const std::shared_ptr<Task> task = std::exchange(m_running, nullptr);
  // The results of a cancelled job are discarded, whatever it still delivered.
  if (task->state.cancelled) {
    task->job.failed(kCancelled);
  } else if (task->error) {
    task->job.failed(*task->error);
  } else if (task->finish) {
    task->finish();
  }
  if (!m_running) startNext();
}

}  // namespace handwheel
