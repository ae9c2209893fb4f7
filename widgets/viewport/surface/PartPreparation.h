// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/surface/PartShape.h"

#include <QObject>
#include <functional>
#include <vector>

namespace handwheel {

// Builds the shapes of parts one by one on a worker thread. They are delivered on the window thread, all that are
// finished at once: the worker does not wait for the window, which may be drawing. A shape in preparation is finished
// and delivered even if it is no longer requested. Therefore a part whose shape changes faster than it can be built
// still shows some of its intermediate states.
class PartPreparation {
 public:
  using Soup = std::shared_ptr<const TriangleSoup>;
  using Receiver = std::function<void(const Soup&, PartShape)>;

  PartPreparation(Receiver receiver, std::function<void()> outOfMemory)
      : m_receiver(std::move(receiver)), m_outOfMemory(std::move(outOfMemory)), m_queue(newQueue()) {}
  ~PartPreparation() { cancel(); }

  // Requests shapes in the given order. They replace the requests that are still waiting.
  void request(const std::vector<Soup>& soups);
  void cancel();
  // Waits for all requested shapes and delivers them.
  void finish();
  bool isUnderWay() const;

 private:
  struct Queue;  // shared by both threads

  std::shared_ptr<Queue> newQueue();
  static void work(Queue& queue);
  void deliver();

  Receiver m_receiver;
  std::function<void()> m_outOfMemory;  // called if memory runs out: a shape will not be delivered
  QObject m_context;                    // receiver of calls from the worker thread
  std::shared_ptr<Queue> m_queue;
};

}  // namespace handwheel
