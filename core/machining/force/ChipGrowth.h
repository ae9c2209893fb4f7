// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace handwheel {

// How thick a chip is along the feed. That is what the edge went on in the last turn of the work: an
// edge that has just touched takes no more than it has gone since, however fast it came: that becomes the feed after
// one turn.
class ChipGrowth {
 public:
  // The edge has cut on a way (mm), in turns of the work. What is not a number does nothing.
  void add(double way, double turns) {
    if (!std::isfinite(way) || !std::isfinite(turns)) return;
    if (!(turns > 0.0)) {
      m_thickness += way;
      return;
    }
    const double feed = way / turns;
    if (m_thickness < feed)
      m_thickness = std::min(feed, m_thickness + way);
    else
      m_thickness = feed + (m_thickness - feed) * std::max(0.0, 1.0 - turns);
  }
  // The edge is clear of the work.
  void end() { m_thickness = 0.0; }

  double thickness() const { return m_thickness; }  // mm

 private:
  double m_thickness = 0.0;
};

}  // namespace handwheel
