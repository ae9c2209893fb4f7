// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/Service.h"

#include "base/ThreadClock.h"

#include <cassert>
#include <utility>

namespace handwheel {

Service::Service(std::string id, std::function<void()> start, std::function<void()> stop)
    : m_id(std::move(id)), m_start(std::move(start)), m_stop(std::move(stop)) {}

ServiceCounters Service::counters() const {
  return {m_ticks.load(std::memory_order_relaxed),
          static_cast<double>(m_nanoseconds.load(std::memory_order_relaxed)) * 1e-3,
          m_starts.load(std::memory_order_relaxed),
          isRunning(),
          static_cast<double>(m_lost.load(std::memory_order_relaxed)) * 1e-9,
          m_dropped.load(std::memory_order_relaxed)};
}

void Service::start() {
  m_starts.fetch_add(1, std::memory_order_relaxed);
  m_running.store(true, std::memory_order_relaxed);
  if (m_start) m_start();
}

void Service::stop() {
  m_running.store(false, std::memory_order_relaxed);
  if (m_stop) m_stop();
}

ServiceTick::ServiceTick(Service& service) : m_service(service), m_start(threadCpuNanoseconds()) {}

ServiceTick::~ServiceTick() {
  m_service.countTick(threadCpuNanoseconds() - m_start);
}

ServiceHandle& ServiceHandle::operator=(ServiceHandle&& other) noexcept {
  if (this == &other) return *this;
  drop();
  m_set = std::exchange(other.m_set, nullptr);
  m_id = std::move(other.m_id);
  return *this;
}

void ServiceHandle::drop() {
  if (m_set) std::exchange(m_set, nullptr)->release(m_id);
}

ServiceRegistry::~ServiceRegistry() {
  for (const auto& entry : m_entries) {
    assert(entry.second.needs == 0 && "a need outlives its set");
    (void)entry;
  }
}

void ServiceRegistry::add(Service& service) {
  Entry& entry = m_entries[service.id()];
  assert(!entry.service && "an id has one service");
  entry.service = &service;
  if (entry.needs > 0) service.start();
}

void ServiceRegistry::remove(Service& service) {
  const auto at = m_entries.find(service.id());
  assert(at != m_entries.end() && at->second.service == &service);
  at->second.service = nullptr;
  if (at->second.needs > 0) service.stop();
}

ServiceHandle ServiceRegistry::need(std::string_view id) {
  std::string name(id);
  Entry& entry = m_entries[name];
  if (++entry.needs == 1 && entry.service) entry.service->start();
  return ServiceHandle(*this, std::move(name));
}

std::size_t ServiceRegistry::needCount(std::string_view id) const {
  const auto at = m_entries.find(id);
  return at == m_entries.end() ? 0 : at->second.needs;
}

void ServiceRegistry::release(const std::string& id) {
  Entry& entry = m_entries.at(id);
  if (--entry.needs == 0 && entry.service) entry.service->stop();
}

}  // namespace handwheel
