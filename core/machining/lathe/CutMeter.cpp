// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/CutMeter.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

void CutMeter::add(const Move& move, double spacing) {
  constexpr double kClear = 3.0;  // samples
  constexpr double kStill = 0.5;  // s
  m_spacing = spacing;
  const double kept = std::exp(-move.length / (kSamples * spacing));
  const bool isCut = move.area > 0.0;
  m_area = kept * m_area + move.area;
  m_volume = kept * m_volume + move.volume;
  m_distance = kept * m_distance + move.length;
  m_turns = kept * m_turns + move.turns;
  m_distanceClear = isCut ? 0.0 : m_distanceClear + move.length;
  m_isCut = m_isCut || isCut;
  if (isCut) m_edge = move.edge;
  m_sinceCut = isCut ? 0.0 : m_sinceCut + move.time;
  m_isCutting = m_isCut && m_distanceClear < kClear * spacing && m_sinceCut < kStill;
  if (m_isCutting) return m_growth.add(move.length, move.turns);
  m_area = m_volume = m_distance = m_turns = 0.0;
  m_growth.end();
}

// A cut that begins has covered less than a sample, but removes the whole sample.
CutConditions CutMeter::cut(double speed) const {
  CutConditions cut;
  if (!m_isCutting) return cut;
  const double distance = std::max(m_distance, m_spacing),
               turns = m_distance > 0.0 ? m_turns * distance / m_distance : 0.0;
  cut.depth = m_edge > 0.0 ? m_edge : m_area / distance;
  if (turns > 0.0) cut.feed = m_edge > 0.0 ? m_area / (turns * m_edge) : m_distance / m_turns;
  cut.speed = surfaceSpeed(std::abs(speed), 2.0 * radius());
  return cut;
}

// The chip of a thread is already measured in its groove.
CutConditions CutMeter::chip(double speed) const {
  CutConditions chip = cut(speed);
  if (!(m_edge > 0.0)) chip.feed = std::min(chip.feed, m_growth.thickness());
  return chip;
}

// Guldin's theorem: the volume is the section times the path of its centroid.
double CutMeter::radius() const {
  return m_area > 0.0 ? m_volume / (2.0 * M_PI * m_area) : 0.0;
}

}  // namespace handwheel
