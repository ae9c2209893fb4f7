// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "controls/ServiceModel.h"

#include <chrono>
#include <memory>

namespace handwheel {

// The background services of the window. They run only while a document or a tool needs them. The Status panel shows
// their statistics.
class WindowServices {
 public:
  WindowServices();

  ServiceRegistry& needs() { return m_needs; }
  // Adds a service of a kind of document; the id of the service must be new. name: the translated name. The service
  // must be removed before it is destroyed.
  void add(Service& service, const QString& name);
  void remove(Service& service);

  Service& autosave() { return m_autosave; }
  Service& selfIntersections() { return m_selfIntersections; }
  Service& fillPreview() { return m_fillPreview; }
  Service& haptics() { return m_haptics; }  // the servo loop of the haptic device

  Service& simulation() { return m_simulation; }  // simulation of moving parts and of material that is being cut

  // Returns the statistics since the last call.
  std::vector<ServiceStatus> status();

 private:
  QString nameOf(const std::string& id) const;

  Service m_autosave;
  Service m_selfIntersections;
  Service m_fillPreview;
  Service m_haptics;
  Service m_simulation;
  ServiceRegistry m_needs;
  std::map<std::string, QString> m_names;  // names of added services
  std::map<std::string, ServiceCounters> m_before;
  std::chrono::steady_clock::time_point m_asked;
};

}  // namespace handwheel
