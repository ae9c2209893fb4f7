// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"

#include <optional>
#include <vector>

namespace handwheel {

// The roughness Ra along a turned part, outside and in the bore: a value for each sample of its profile, with the
// radius that it was measured at. What something else has cut since has another radius, and counts as not known.
class SurfaceFinish {
 public:
  static constexpr double kDrawn = 3.2;      // µm, of a bar before it is cut
  static constexpr double kRoughest = 50.0;  // µm, that are told apart

  explicit SurfaceFinish(std::size_t samples);

  std::size_t size() const { return m_outer.size(); }
  // µm; none: not known. radius: mm, of the sample now.
  std::optional<double> at(TurningSide side, std::size_t i, double radius) const;
  void set(TurningSide side, std::size_t i, double radius, double roughness);

  // The mean of those that are known of these samples; none where none is.
  std::optional<double> mean(const TurnedProfile& profile, TurningSide side, TurnedProfile::Range samples) const;

 private:
  struct Mark {
    double radius = -1.0;    // mm; below 0: none
    float roughness = 0.0f;  // µm
  };
  std::vector<Mark> m_outer, m_inner;
};

// The roughness that an edge leaves, µm: by the geometry of feed (mm in a turn) and nose (mm), within what is told
// apart.
double turnedRoughness(double feed, double noseRadius);

// The roughness after an abrasive has taken `removed` mm off: the grooves are about four times as deep as Ra, and their
// crests go first. It comes no lower than the grain lets it, and what was finer gets the marks of the grain.
double abradedRoughness(double before, double removed, double least);

}  // namespace handwheel
