// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parallel_for.h"

#include <mutex>
#include <utility>

namespace tbb {

template <class Index, class Value>
Value parallel_reduce(const blocked_range<Index>& range, const Value& identity, const auto& body, const auto& join) {
  std::mutex mutex;
  Value result = identity;
  parallel_for(range, [&](const blocked_range<Index>& part) {
    Value value = body(part, identity);
    const std::scoped_lock lock(mutex);
    result = join(std::move(result), std::move(value));
  });
  return result;
}

}  // namespace tbb
