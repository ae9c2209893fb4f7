// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "controls/ServiceModel.h"

#include <chrono>
#include <memory>

namespace handwheel {

// What runs beside the window, and only while a document or a tool needs it. Everything that works in the background
// measures its ticks here, so the Status panel can say what it costs.
class WindowServices {
 public:
  WindowServices();

  NeedSet& needs() { return m_needs; }
  Service& autosave() { return m_autosave; }
  Service& selfIntersections() { return m_selfIntersections; }
  Service& fillPreview() { return m_fillPreview; }
  Service& haptics() { return m_haptics; }  // the servo loop of the device; its ticks are the loop's

  // What each has cost so far that runs now, by its translated name: CPU time in µs.
  std::vector<std::pair<QString, double>> costs() const;
  // The figures since the last call.
  std::vector<ServiceStatus> status();

 private:
  Service m_autosave;
  Service m_selfIntersections;
  Service m_fillPreview;
  Service m_haptics;
  NeedSet m_needs;
  std::map<std::string, ServiceCounters> m_before;
  std::chrono::steady_clock::time_point m_asked;
};

}  // namespace handwheel
