// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/surface/PartShape.h"

#include <QFutureWatcher>
#include <deque>
#include <functional>

namespace handwheel {

// Builds the shapes of parts one by one on a worker thread. They are delivered on the window thread. A shape in
// preparation is finished and delivered even if it is no longer requested. Therefore a part whose shape changes faster
// than it can be built still shows some of its intermediate states.
class PartPreparation {
 public:
  using Soup = std::shared_ptr<const TriangleSoup>;
  using Receiver = std::function<void(const Soup&, PartShape)>;

  PartPreparation(Receiver receiver, std::function<void()> outOfMemory)
      : m_receiver(std::move(receiver)), m_outOfMemory(std::move(outOfMemory)) {}
  ~PartPreparation() { cancel(); }

  // Requests shapes in the given order. They replace the requests that are still waiting.
  void request(const std::vector<Soup>& soups);
  void cancel();
  // Waits for all requested shapes and delivers them.
  void finish();
  bool isUnderWay() const { return m_run != nullptr; }

 private:
  using Run = QFutureWatcher<std::shared_ptr<PartShape>>;  // shared, because futures return copies

  void startNext();
  void deliver();

  Receiver m_receiver;
  std::function<void()> m_outOfMemory;  // called if memory runs out: a shape will not be delivered
  std::deque<Soup> m_waiting;
  Soup m_present;  // the soup of the run
  std::unique_ptr<Run> m_run;
  int m_serial = 0;  // serial number of the run
  QObject m_context;
};

}  // namespace handwheel
