// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "machining/TurningPass.h"

namespace handwheel {

// Builds the pass of a tool that a hand moves. Live input and recordings give the same pass, bit for bit.
class HandPass {
 public:
  // blank: a pass without points, with the tool. base: z of the part's lower end in the coordinates of the hand, mm.
  // mostPoints: the largest number of points of the pass.
  HandPass(TurningPass blank, double base, std::size_t mostPoints = TurningPass::kMostPoints)
      : m_pass(std::move(blank)), m_base(base), m_mostPoints(mostPoints) {}

  // Adds the next position of the nose's centre, mm. time: the time on any clock, s. speed: the speed of the spindle,
  // r/min; 0: not known. Returns the number of points added: usually 1; 2 if the motion passes the axis, since the
  // point nearest to the axis is added first; 0 if the pass is full.
  std::size_t add(const Vec3& position, double time, double speed);

  const TurningPass& pass() const { return m_pass; }
  bool isFull() const { return m_pass.path.size() >= m_mostPoints; }

 private:
  void addPoint(const Vec3& position, double time, double speed);

  TurningPass m_pass;
  double m_base;
  std::size_t m_mostPoints;
  double m_begin = 0.0;            // s, time of the first point
  Vec3 m_position = Vec3::Zero();  // mm, last position
  double m_time = 0.0;
};

}  // namespace handwheel
