// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/PartPreparation.h"

#include "viewport/Worker.h"

#include <algorithm>

namespace handwheel {

void PartPreparation::request(const std::vector<Soup>& soups) {
  m_waiting.assign(soups.begin(), soups.end());
  std::erase(m_waiting, m_present);
  if (!m_run) startNext();
}

void PartPreparation::cancel() {
  m_waiting.clear();
  m_present.reset();
  if (m_run) m_run->cancel();
  m_run.reset();
}

void PartPreparation::finish() {
  while (m_run) {
    m_run->waitForFinished();
    deliver();
  }
}

void PartPreparation::startNext() {
  m_run.reset();
  m_present.reset();
  if (m_waiting.empty()) return;
  m_present = m_waiting.front();
  m_waiting.pop_front();
  m_run = runOnWorker<std::shared_ptr<PartShape>>([soup = m_present](QPromise<std::shared_ptr<PartShape>>& promise) {
    if (!promise.isCanceled()) promise.addResult(std::make_shared<PartShape>(shapeOf(*soup)));
  });
  // Queued: a watcher must not be destroyed by its own report.
  QObject::connect(
      m_run.get(), &QFutureWatcherBase::finished, &m_context,
      [this, serial = ++m_serial] {
        if (m_run && serial == m_serial) deliver();
      },
      Qt::QueuedConnection);
}

void PartPreparation::deliver() {
  const std::shared_ptr<PartShape> shape = m_run->future().resultCount() > 0 ? m_run->result() : nullptr;
  const Soup soup = m_present;
  startNext();
  if (!shape) return m_outOfMemory();
  m_receiver(soup, std::move(*shape));
}

}  // namespace handwheel
