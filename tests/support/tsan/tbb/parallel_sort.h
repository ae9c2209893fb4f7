// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace tbb {

// On one thread: what is sorted is not shared.
template <class Range, class Compare>
void parallel_sort(Range& range, Compare isLess) {
  std::sort(range.begin(), range.end(), isLess);
}

}  // namespace tbb
