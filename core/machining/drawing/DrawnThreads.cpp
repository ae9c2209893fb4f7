// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/DrawnThreads.h"

#include "machining/thread/ThreadDesignation.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace handwheel {

namespace {

std::optional<DrawnThread> drawn(const TurnedProfile& part, const ThreadGroove& groove, double base) {
  const bool isInner = groove.side() == TurningSide::Bore;
  std::vector<double> crests;
  double low = 0.0, high = 0.0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double r = isInner ? part.inner(i) : part.radius(i), z = part.z(i);
    const bool isCut = isInner ? r > 0.0 && r < groove.deepest() : r > groove.deepest();
    if (!part.hasMaterial(i) || !isCut || z < groove.from() || z > groove.to()) continue;
    if (crests.empty()) low = z;
    high = z;
    crests.push_back(r);
  }
  if (crests.size() < 2) return std::nullopt;
  // The median: chamfers and reliefs are the lesser part.
  const auto middle = crests.begin() + static_cast<std::ptrdiff_t>(crests.size() / 2);
  std::nth_element(crests.begin(), middle, crests.end());
  const double crest = 2.0 * *middle, root = 2.0 * groove.deepest();
  DrawnThread thread;
  thread.isInner = isInner;
  thread.major = isInner ? root : crest;
  thread.minor = isInner ? crest : root;
  thread.low = base + low;
  thread.high = base + high;
  thread.designation = threadDesignation(groove.cut(), thread.major, isInner);
  return thread;
}

}  // namespace

std::vector<DrawnThread> drawnThreads(const TurnedProfile& part, const PartThreads& threads, double base) {
  std::vector<DrawnThread> all;
  for (const ThreadGroove& groove : threads.grooves()) {
    std::optional<DrawnThread> thread = drawn(part, groove, base);
    if (!thread) continue;
    // The starts of one thread are grooves of their own.
    const auto same = std::find_if(all.begin(), all.end(), [&](const DrawnThread& other) {
      const bool isBeside = thread->low < other.high && other.low < thread->high;
      return isBeside && other.isInner == thread->isInner && other.designation == thread->designation;
    });
    if (same == all.end()) {
      all.push_back(std::move(*thread));
    } else {
      same->low = std::min(same->low, thread->low);
      same->high = std::max(same->high, thread->high);
    }
  }
  return all;
}

}  // namespace handwheel
