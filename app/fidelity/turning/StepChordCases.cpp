// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshFormat.h"
#include "fidelity/Cases.h"
#include "fidelity/SeededInput.h"
#include "nurbs/CylinderDistance.h"
#include "nurbs/StepWriter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

constexpr double kBallRadius = 25.0;  // mm

// From pole to pole: a half circle of two exact arcs.
ProfileNurbs halfCircle() {
  const double r = kBallRadius, w = std::sqrt(0.5);
  return {2, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, -r}, {r, -r}, {r, 0}, {r, r}, {0, r}}, {1, w, 1, w, 1}};
}

// Returns the largest distance of triangles that are inscribed into the ball, at positions all over them.
double distanceToBall(const TriangleSoup& soup) {
  constexpr int kSteps = 6;
  double largest = 0.0;
  for (const Triangle& t : soup.triangles) {
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const Vec3 sum = i * soup.points[t[0]] + j * soup.points[t[1]] + (kSteps - i - j) * soup.points[t[2]];
        largest = std::max(largest, std::abs(kBallRadius - sum.norm() / kSteps));
      }
    }
  }
  return largest;
}

FidelityCase stepCaseOn(const std::string& name, const ProfileCurve& profile, double diagonal,
                        const std::function<double(const TriangleSoup&)>& distance) {
  const SeededInput<std::string> file([profile](std::uint64_t) {
    const Result<std::string> bytes = writeStep(profile);
    return bytes ? *bytes : std::string();
  });
  return {name, "closed form", [file, diagonal, distance](double chord, std::uint64_t seed, Progress progress) {
            constexpr double kPercent = 100.0;
            FidelitySample sample;
            sample.error = std::numeric_limits<double>::infinity();
            const Result<MeshFile> mesh = readMesh(file(seed), "case.step", {.stepChord = chord}, progress);
            if (!mesh) return sample;
            sample.error = kPercent * distance(mesh->soup) / diagonal;
            sample.cost = static_cast<double>(mesh->soup.triangles.size());
            return sample;
          }};
}

}  // namespace

std::vector<FidelityCase> stepChordCases() {
  const StockCylinder bar{50.0, 100.0, 0.0};
  return {stepCaseOn("bar 50 x 100 mm", bar.profile(), bar.bounds().diagonal().norm(),
                     [bar](const TriangleSoup& soup) { return distanceToCylinder(soup, bar); }),
          stepCaseOn("ball of 50 mm", ProfileCurve::make(halfCircle()).value(), 2 * kBallRadius * std::sqrt(3.0),
                     distanceToBall)};
}

}  // namespace handwheel
