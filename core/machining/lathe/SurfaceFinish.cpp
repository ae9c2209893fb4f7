// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/SurfaceFinish.h"

#include "machining/measure/RoughnessGrade.h"

#include <algorithm>

namespace handwheel {

namespace {
constexpr double kDepthByRa = 4.0;    // of the grooves of a turned surface: f²/8R by f²/32R
constexpr double kMicrometres = 1e3;  // in a mm
}  // namespace

SurfaceFinish::SurfaceFinish(std::size_t samples) : m_outer(samples), m_inner(samples) {}

std::optional<double> SurfaceFinish::at(TurningSide side, std::size_t i, double radius) const {
  const std::vector<Mark>& marks = side == TurningSide::Outside ? m_outer : m_inner;
  if (i >= marks.size() || marks[i].radius != radius) return std::nullopt;
  return marks[i].roughness;
}

void SurfaceFinish::set(TurningSide side, std::size_t i, double radius, double roughness) {
  std::vector<Mark>& marks = side == TurningSide::Outside ? m_outer : m_inner;
  if (i < marks.size()) marks[i] = {radius, static_cast<float>(std::clamp(roughness, 0.0, kRoughest))};
}

std::optional<double> SurfaceFinish::mean(const TurnedProfile& profile, TurningSide side,
                                          TurnedProfile::Range samples) const {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = samples.first; i < std::min(samples.last, profile.size()); ++i) {
    const double radius = side == TurningSide::Outside ? profile.radius(i) : profile.inner(i);
    const std::optional<double> here = at(side, i, radius);
    if (!here) continue;
    sum += *here;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

double turnedRoughness(double feed, double noseRadius) {
  return std::min(idealRoughness(feed, noseRadius), SurfaceFinish::kRoughest);
}

double abradedRoughness(double before, double removed, double least) {
  return std::max(least, before - kMicrometres * removed / kDepthByRa);
}

}  // namespace handwheel
