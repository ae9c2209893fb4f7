// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace handwheel {

// The thickness of a chip along the feed. It is the distance that the edge covered in the last turn of the work. An
// edge that has just touched the work takes a chip no thicker than the distance it has moved since, at any speed. After
// one turn the thickness has become the feed.
class ChipGrowth {
 public:
  // Adds a cut over a distance (mm) during this number of turns of the work. Values that are not finite do nothing.
  void add(double distance, double turns) {
    if (!std::isfinite(distance) || !std::isfinite(turns)) return;
    if (!(turns > 0.0)) {
      m_thickness += distance;
      return;
    }
    const double feed = distance / turns;
    if (m_thickness < feed)
      m_thickness = std::min(feed, m_thickness + distance);
    else
      m_thickness = feed + (m_thickness - feed) * std::max(0.0, 1.0 - turns);
  }
  // Ends the cut: the edge is clear of the work.
  void end() { m_thickness = 0.0; }

  double thickness() const { return m_thickness; }  // mm

 private:
  double m_thickness = 0.0;
};

}  // namespace handwheel
