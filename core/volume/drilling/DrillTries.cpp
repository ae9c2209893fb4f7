// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillTries.h"

#include "base/Fingerprint.h"

#include <algorithm>
#include <set>

namespace handwheel {
namespace {

std::set<std::uint64_t> marksOf(std::span<const std::shared_ptr<const DrillRecord>> holes) {
  std::set<std::uint64_t> marks;
  for (const auto& hole : holes) marks.insert(fingerprintOf(*hole));
  return marks;
}

}  // namespace

std::uint64_t fingerprintOf(const DrillRecord& hole) {
  Fingerprint mark;
  mark.add(static_cast<std::uint64_t>(hole.setup.tool.shape));
  mark.add(hole.setup.tool.diameter);
  mark.add(hole.setup.spindle);
  for (std::size_t i = 0; i < hole.poses.size(); ++i) addTo(mark, hole.poses[i]);
  return mark.value();
}

TriedHoles withHole(TriedHoles tried, std::span<const std::shared_ptr<const DrillRecord>> present,
                    const DrillRecord& hole, double forbidden) {
  std::uint32_t number = 1;
  if (!tried.empty()) {
    number = tried.back().number;
    const std::set<std::uint64_t> marks = marksOf(present);
    const bool isTakenBack = std::any_of(tried.begin(), tried.end(), [&](const TriedHole& each) {
      return each.number == number && !marks.contains(each.mark);
    });
    if (isTakenBack) ++number;
  }
  if (tried.size() >= TriedHole::kMost) tried.erase(tried.begin());
  tried.push_back({fingerprintOf(hole), forbidden, number});
  return tried;
}

std::uint32_t triesCounted(const TriedHoles* tried, std::span<const std::shared_ptr<const DrillRecord>> present) {
  if (tried && !tried->empty()) return tried->back().number;
  return present.empty() ? 0 : 1;
}

DrillTries triesOf(const TriedHoles* tried, std::span<const std::shared_ptr<const DrillRecord>> present) {
  DrillTries all;
  all.count = triesCounted(tried, present);
  if (!tried || tried->empty()) return all;
  const std::set<std::uint64_t> marks = marksOf(present);
  for (const TriedHole& each : *tried) {
    if (!(each.forbidden > 0.0) || marks.contains(each.mark)) continue;
    if (all.failed.empty() || all.failed.back().number != each.number) all.failed.push_back({each.number, 0.0});
    all.failed.back().forbidden = std::max(all.failed.back().forbidden, each.forbidden);
  }
  return all;
}

}  // namespace handwheel
