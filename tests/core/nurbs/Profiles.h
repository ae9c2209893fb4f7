// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "nurbs/ProfileCurve.h"

#include <rapidcheck.h>

#include <cmath>

// Profiles for tests, and the textbook definition of a B-spline as a reference.
namespace handwheel::test {

// Returns the basis function N(i, p) at u by the Cox–de Boor recursion. The last span includes its end.
inline double basis(const std::vector<double>& knots, std::size_t i, int degree, double u) {
  if (degree == 0) {
    const bool isLast = knots[i + 1] == knots.back() && knots[i] < knots.back();
    return (u >= knots[i] && u < knots[i + 1]) || (isLast && u == knots.back()) ? 1.0 : 0.0;
  }
  const auto p = static_cast<std::size_t>(degree);
  double sum = 0.0;
  if (knots[i + p] > knots[i]) sum += (u - knots[i]) / (knots[i + p] - knots[i]) * basis(knots, i, degree - 1, u);
  if (knots[i + p + 1] > knots[i + 1])
    sum += (knots[i + p + 1] - u) / (knots[i + p + 1] - knots[i + 1]) * basis(knots, i + 1, degree - 1, u);
  return sum;
}

inline ProfilePoint pointByDefinition(const ProfileNurbs& nurbs, double u) {
  ProfilePoint sum(0, 0);
  double weights = 0.0;
  for (std::size_t i = 0; i < nurbs.poles.size(); ++i) {
    const double share = nurbs.weights[i] * basis(nurbs.knots, i, nurbs.degree, u);
    sum += share * nurbs.poles[i];
    weights += share;
  }
  return sum / weights;
}

// Returns a value that is uniform over the whole range, even in RapidCheck's first tests, which use small sizes.
inline double between(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

// Returns a random sound profile of any degree. It may have simple and multiple inner knots, double poles, poles on the
// axis and unequal weights.
inline ProfileNurbs randomNurbs() {
  ProfileNurbs nurbs;
  nurbs.degree = *rc::gen::inRange(1, 4);
  const auto spans = *rc::gen::inRange(1, 7);
  nurbs.knots.assign(nurbs.degree + 1, 0.0);
  double knot = 0.0;
  for (int i = 1; i < spans; ++i) {
    knot += between(0.01, 2.0);
    nurbs.knots.insert(nurbs.knots.end(), *rc::gen::inRange(1, nurbs.degree + 1), knot);
  }
  nurbs.knots.insert(nurbs.knots.end(), nurbs.degree + 1, knot + between(0.01, 2.0));
  while (nurbs.poles.size() + nurbs.degree + 1 < nurbs.knots.size()) {
    const bool isDouble = !nurbs.poles.empty() && *rc::gen::inRange(0, 5) == 0;
    nurbs.poles.push_back(isDouble ? nurbs.poles.back()
                                   : ProfilePoint(std::max(0.0, between(-2.0, 10.0)), between(-20.0, 20.0)));
    nurbs.weights.push_back(between(0.2, 5.0));
  }
  return nurbs;
}

// Returns the exact profile of a sphere, which is a half circle from pole to pole.
inline ProfileNurbs sphere(double radius, double centre) {
  const double w = std::sqrt(0.5);
  return {2,
          {0, 0, 0, 1, 1, 2, 2, 2},
          {{0, centre - radius},
           {radius, centre - radius},
           {radius, centre},
           {radius, centre + radius},
           {0, centre + radius}},
          {1, w, 1, w, 1}};
}

}  // namespace handwheel::test
