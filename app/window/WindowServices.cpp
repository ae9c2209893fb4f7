// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/WindowServices.h"

#include <QCoreApplication>
#include <algorithm>

namespace handwheel {

namespace {

struct WindowServicesWords {
  Q_DECLARE_TR_FUNCTIONS(WindowServices)
};

QString ownName(const std::string& id) {
  if (id == "autosave") return WindowServicesWords::tr("Autosave");
  if (id == "self_intersections") return WindowServicesWords::tr("Search for self-intersections");
  if (id == "haptics") return WindowServicesWords::tr("Servo loop of the device");
  if (id == "simulation") return WindowServicesWords::tr("Simulation");
  return WindowServicesWords::tr("Preview of the patch");
}

double microsecondsPerTick(const ServiceCounters& counters) {
  return counters.ticks > 0 ? counters.cpuMicroseconds / static_cast<double>(counters.ticks) : 0.0;
}

}  // namespace

WindowServices::WindowServices()
    : m_autosave("autosave"),
      m_selfIntersections("self_intersections"),
      m_fillPreview("fill_preview"),
      m_haptics("haptics"),
      m_simulation("simulation"),
      m_asked(std::chrono::steady_clock::now()) {
  for (Service* service : {&m_autosave, &m_selfIntersections, &m_fillPreview, &m_haptics, &m_simulation})
    m_needs.add(*service);
}

void WindowServices::add(Service& service, const QString& name) {
  m_names[service.id()] = name;
  m_needs.add(service);
}

void WindowServices::remove(Service& service) {
  m_needs.remove(service);
  m_names.erase(service.id());
  m_before.erase(service.id());
}

QString WindowServices::nameOf(const std::string& id) const {
  const auto added = m_names.find(id);
  return added == m_names.end() ? ownName(id) : added->second;
}

std::vector<ServiceStatus> WindowServices::status() {
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::max(1e-3, std::chrono::duration<double>(now - m_asked).count());
  m_asked = now;
  std::vector<ServiceStatus> all;
  m_needs.forEach([&](const Service& service) {
    const ServiceCounters counters = service.counters();
    ServiceCounters& before = m_before[service.id()];
    const auto ticks = static_cast<double>(counters.ticks - before.ticks);
    ServiceStatus status;
    status.id = QString::fromStdString(service.id());
    status.name = nameOf(service.id());
    status.running = counters.running;
    status.ticksPerSecond = ticks / seconds;
    status.microsecondsPerTick = microsecondsPerTick(counters);
    status.behind = (counters.lostSeconds - before.lostSeconds) / seconds;
    status.dropped = static_cast<int>(counters.dropped - before.dropped);
    before = counters;
    all.push_back(status);
  });
  return all;
}

}  // namespace handwheel
