// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileSegment.h"

#include <rapidcheck.h>

#include <cmath>
#include <vector>

// Random profiles of parts for tests.
namespace handwheel::test {

// Returns a value that is uniform over the whole range, even in RapidCheck's first tests, which use small sizes.
inline double evenly(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

inline bool isAt(const ProfilePoint& p, double x, double y) {
  return (p - ProfilePoint(x, y)).norm() < 1e-9;
}

inline ProfileSegment anySegment(double size) {
  const auto point = [&] { return ProfilePoint(evenly(-size, size), evenly(-size, size)); };
  const bool isArc = evenly(0.0, 3.0) > 1.0;
  return {point(), point(), isArc ? std::tan(0.25 * evenly(-1.9 * M_PI, 1.9 * M_PI)) : 0.0};
}

// Returns the outline of a shaft of 1 to 6 steps with shoulders, tapers and fillets. The outline runs from its lower
// end on the axis to its upper end, and no step crosses another.
inline std::vector<ProfileSegment> anyShaft() {
  std::vector<ProfileSegment> all;
  ProfilePoint at(0.0, 0.0);
  const auto line = [&](double r, double z) {
    all.push_back({at, ProfilePoint(r, z), 0.0});
    at = {r, z};
  };
  line(evenly(2.0, 30.0), 0.0);
  const int steps = *rc::gen::inRange(1, 7);
  for (int i = 0; i < steps; ++i) {
    const int form = *rc::gen::inRange(0, 4);
    const double length = evenly(1.0, 20.0), r = evenly(2.0, 30.0);
    if (form == 0) line(at.x(), at.y() + length);  // cylinder
    if (form == 1) line(r, at.y() + length);       // taper
    if (form == 2) {                               // shoulder
      line(at.x(), at.y() + length);
      if (std::abs(r - at.x()) > 0.1) line(r, at.y());
    }
    if (form == 3) {  // arc over the length, at most a tenth of a circle
      const ProfilePoint to(r, at.y() + length);
      const ProfileSegment arc{at, to, std::tan(0.25 * evenly(-0.6, 0.6))};
      all.push_back(arc);
      at = to;
    }
  }
  line(at.x(), at.y() + 1.0);
  line(0.0, at.y());
  return all;
}

}  // namespace handwheel::test
