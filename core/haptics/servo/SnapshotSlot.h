// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

namespace handwheel {

// Lock-free slot that passes snapshots to a real-time thread, and back. Snapshots return to the producer thread to be
// freed. (std::atomic<shared_ptr> locks in libstdc++, and the last owner would free the snapshot.) Ownership is passed
// by two atomic pointers, so that at any moment each snapshot belongs to one thread and need not be marked as in use.
// Neither thread ever waits.
template <class T>
class SnapshotSlot {
 public:
  SnapshotSlot() = default;
  ~SnapshotSlot() {  // must be called when neither thread uses the slot any more
    delete m_incoming.load(std::memory_order_relaxed);
    delete m_retired.load(std::memory_order_relaxed);
    delete m_leaving;
    delete m_current;
  }
  SnapshotSlot(const SnapshotSlot&) = delete;
  SnapshotSlot& operator=(const SnapshotSlot&) = delete;

  // Makes a snapshot available to the next take(). A snapshot that was never taken is freed. Must be called on the
  // producer thread.
  void publish(std::unique_ptr<T> snapshot) {
    delete m_incoming.exchange(snapshot.release(), std::memory_order_acq_rel);
    collect();
  }

  // Frees the snapshot that the real-time thread no longer uses. Returns true if there was one. Must be called on the
  // producer thread.
  bool collect() {
    const std::unique_ptr<T> retired(m_retired.exchange(nullptr, std::memory_order_acq_rel));
    return retired != nullptr;
  }

  // Result of take().
  struct Taken {
    T* current = nullptr;         // snapshot in use until the next take(); null before the first snapshot
    const T* previous = nullptr;  // the snapshot before `current` if that is new; readable until the next take()
    bool isNew = false;
  };
  Taken take() noexcept {
    // The snapshot before the last one that was taken is returned first, so that `previous` lives through a tick.
    if (m_leaving) {
      T* none = nullptr;
      if (!m_retired.compare_exchange_strong(none, m_leaving, std::memory_order_acq_rel))
        return {m_current, nullptr, false};
      m_leaving = nullptr;
    }
    if (!m_incoming.load(std::memory_order_relaxed)) return {m_current, nullptr, false};
    m_leaving = m_current;
    m_current = m_incoming.exchange(nullptr, std::memory_order_acq_rel);
    return {m_current, m_leaving, true};
  }

 private:
  std::atomic<T*> m_incoming{nullptr};
  std::atomic<T*> m_retired{nullptr};
  T* m_current = nullptr;  // owned by the real-time thread
  T* m_leaving = nullptr;
};

}  // namespace handwheel
