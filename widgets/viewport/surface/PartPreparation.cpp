// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/PartPreparation.h"

#include <QThreadPool>
#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <utility>

namespace handwheel {

struct PartPreparation::Queue {
  std::mutex mutex;
  std::condition_variable isMade;
  std::deque<Soup> waiting;
  Soup present;  // the soup of the shape in preparation; null: no thread is at work
  std::deque<std::pair<Soup, std::shared_ptr<PartShape>>> made;  // not delivered yet; a null shape: memory ran out
  bool isAnnounced = false;                                      // the window thread will look at `made`
  std::function<void()> announce;                                // null: nobody wants the shapes any more
};

std::shared_ptr<PartPreparation::Queue> PartPreparation::newQueue() {
  auto queue = std::make_shared<Queue>();
  queue->announce = [this] {
    QMetaObject::invokeMethod(
        &m_context, [this] { deliver(); }, Qt::QueuedConnection);
  };
  return queue;
}

void PartPreparation::request(const std::vector<Soup>& soups) {
  {
    const std::lock_guard lock(m_queue->mutex);
    m_queue->waiting.assign(soups.begin(), soups.end());
    std::erase_if(m_queue->waiting, [&](const Soup& soup) {
      const auto isOfIt = [&](const auto& made) { return made.first == soup; };
      return soup == m_queue->present || std::any_of(m_queue->made.begin(), m_queue->made.end(), isOfIt);
    });
    if (m_queue->present || m_queue->waiting.empty()) return;
    m_queue->present = m_queue->waiting.front();
    m_queue->waiting.pop_front();
  }
  QThreadPool::globalInstance()->start([queue = m_queue] { work(*queue); });
}

// Runs on a worker thread.
void PartPreparation::work(Queue& queue) {
  Soup soup = queue.present;  // set before the thread started
  while (soup) {
    std::shared_ptr<PartShape> shape;
    try {
      shape = std::make_shared<PartShape>(shapeOf(*soup));
    } catch (const std::bad_alloc&) {  // the receiver sees the missing shape
    }
    const std::lock_guard lock(queue.mutex);
    if (!queue.announce) return;
    queue.made.emplace_back(std::move(soup), std::move(shape));
    soup = queue.waiting.empty() ? nullptr : queue.waiting.front();
    if (soup) queue.waiting.pop_front();
    queue.present = soup;
    queue.isMade.notify_one();
    // Under the lock: the context is there as long as it is wanted.
    if (!std::exchange(queue.isAnnounced, true)) queue.announce();
  }
}

void PartPreparation::cancel() {
  {
    const std::lock_guard lock(m_queue->mutex);
    m_queue->announce = nullptr;
    m_queue->waiting.clear();
    m_queue->made.clear();
  }
  m_queue = newQueue();
}

bool PartPreparation::isUnderWay() const {
  const std::lock_guard lock(m_queue->mutex);
  return m_queue->present || !m_queue->made.empty();
}

void PartPreparation::finish() {
  while (isUnderWay()) {
    {
      std::unique_lock lock(m_queue->mutex);
      m_queue->isMade.wait(lock, [this] { return !m_queue->made.empty(); });
    }
    deliver();
  }
}

// The receiver requests what is missing then. A shape that is delivered soon is not among it.
void PartPreparation::deliver() {
  for (;;) {
    Soup soup;
    std::shared_ptr<PartShape> shape;
    {
      const std::lock_guard lock(m_queue->mutex);
      if (m_queue->made.empty()) {
        m_queue->isAnnounced = false;
        return;
      }
      std::tie(soup, shape) = std::move(m_queue->made.front());
      m_queue->made.pop_front();
    }
    shape ? m_receiver(soup, std::move(*shape)) : m_outOfMemory();
  }
}

}  // namespace handwheel
