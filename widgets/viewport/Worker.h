// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QPromise>
#include <QThreadPool>
#include <memory>
#include <new>

namespace handwheel {

// Runs work(promise) on a worker thread and returns a watcher of its future. Destroying the watcher drops pending
// results. When memory runs out, the work ends with fewer results, and the future is not marked as cancelled.
template <class T, class Work>
std::unique_ptr<QFutureWatcher<T>> runOnWorker(Work work) {
  auto promise = std::make_shared<QPromise<T>>();
  auto watcher = std::make_unique<QFutureWatcher<T>>();
  watcher->setFuture(promise->future());
  promise->start();
  QThreadPool::globalInstance()->start([promise, work = std::move(work)] {
    try {
      work(*promise);
    } catch (const std::bad_alloc&) {  // the caller sees the missing results
    }
    promise->finish();
  });
  return watcher;
}

}  // namespace handwheel
