// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace handwheel {

// The usage counters of a service.
struct ServiceCounters {
  std::uint64_t ticks = 0;
  double cpuMicroseconds = 0.0;  // sum over all ticks, on the threads that ran them
  std::uint64_t starts = 0;
  bool running = false;
  double lostSeconds = 0.0;   // time that was lost because late ticks are not made up for
  std::uint64_t dropped = 0;  // inputs that the service did not accept in time
};

// A background activity that runs only while a document or tool needs it. Examples are surface contact, snapping, rigid
// bodies and sound. The functions that start and stop it are called on the thread that owns the ServiceRegistry.
// Counters may be read and ticks measured on any thread, without locks.
class Service {
 public:
  explicit Service(std::string id, std::function<void()> start = {}, std::function<void()> stop = {});
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;

  const std::string& id() const { return m_id; }
  ServiceCounters counters() const;
  bool isRunning() const { return m_running.load(std::memory_order_relaxed); }
  // Counts one tick whose cost the caller has measured. It is used where querying the CPU time, a system call, is not
  // allowed.
  void countTick(std::uint64_t nanoseconds) noexcept {
    m_ticks.fetch_add(1, std::memory_order_relaxed);
    m_nanoseconds.fetch_add(nanoseconds, std::memory_order_relaxed);
  }
  // Count lost time and inputs that the service did not accept in time.
  void countLost(std::uint64_t nanoseconds) noexcept { m_lost.fetch_add(nanoseconds, std::memory_order_relaxed); }
  void countDropped(std::uint64_t inputs) noexcept { m_dropped.fetch_add(inputs, std::memory_order_relaxed); }

 private:
  friend class ServiceRegistry;
  void start();
  void stop();

  const std::string m_id;
  const std::function<void()> m_start;
  const std::function<void()> m_stop;
  std::atomic<std::uint64_t> m_ticks{0};
  std::atomic<std::uint64_t> m_nanoseconds{0};
  std::atomic<std::uint64_t> m_starts{0};
  std::atomic<std::uint64_t> m_lost{0};  // ns
  std::atomic<std::uint64_t> m_dropped{0};
  std::atomic<bool> m_running{false};
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "ticks are counted on real-time threads");
};

// Counts one tick of a service and its CPU time from construction to destruction. It must be used on the thread that
// does the work, and neither allocates nor locks.
class ServiceTick {
 public:
  explicit ServiceTick(Service& service);
  ~ServiceTick();
  ServiceTick(const ServiceTick&) = delete;
  ServiceTick& operator=(const ServiceTick&) = delete;

 private:
  Service& m_service;
  std::uint64_t m_start;
};

class ServiceRegistry;

// A handle that keeps a service running during its lifetime. Its ServiceRegistry must outlive it.
class ServiceHandle {
 public:
  ServiceHandle() = default;  // keeps nothing running
  ServiceHandle(ServiceHandle&& other) noexcept : m_set(other.m_set), m_id(std::move(other.m_id)) {
    other.m_set = nullptr;
  }
  ServiceHandle& operator=(ServiceHandle&& other) noexcept;
  ~ServiceHandle() { drop(); }

  bool isNeeded() const { return m_set != nullptr; }

 private:
  friend class ServiceRegistry;
  ServiceHandle(ServiceRegistry& set, std::string id) : m_set(&set), m_id(std::move(id)) {}
  void drop();

  ServiceRegistry* m_set = nullptr;
  std::string m_id;
};

// A reference-counted set of services. A service starts with the first handle for its id and stops with the last; a
// handle may be created before its service is added. All functions must be called on one thread.
class ServiceRegistry {
 public:
  ServiceRegistry() = default;
  ~ServiceRegistry();
  ServiceRegistry(const ServiceRegistry&) = delete;
  ServiceRegistry& operator=(const ServiceRegistry&) = delete;

  // Adds a service, which must outlive this registry or be removed. Its id must be new.
  void add(Service& service);
  void remove(Service& service);  // stops the service

  [[nodiscard]] ServiceHandle need(std::string_view id);
  std::size_t needCount(std::string_view id) const;

  // Calls visit(const Service&) for each added service, in order of the ids.
  template <class Visit>
  void forEach(Visit visit) const {
    for (const auto& entry : m_entries) {
      if (entry.second.service) visit(static_cast<const Service&>(*entry.second.service));
    }
  }

 private:
  friend class ServiceHandle;
  void release(const std::string& id);

  struct Entry {
    Service* service = nullptr;  // null: needed, but not added yet
    std::size_t needs = 0;
  };
  std::map<std::string, Entry, std::less<>> m_entries;
};

}  // namespace handwheel
