// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/Cases.h"
#include "machining/TurnedSurface.h"
#include "machining/TurningFidelity.h"
#include "machining/TurningPass.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr StockCylinder kPassedBar{50.0, 100.0, 0.0};
constexpr double kFeedStep = 0.25;   // mm, of the path in one step of the simulation
constexpr double kPassDepth = 0.25;  // mm
constexpr int kPasses = 4;
constexpr double kPassNose = 1.0;  // mm

double distanceToLine(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b) {
  const ProfilePoint along = b - a;
  const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - a - t * along).norm();
}

// The last pass of a round nose, from one position to another, with the distance of a point from the ideal surface. The
// previous passes are further out, each by the depth.
struct StraightPass {
  std::string name;
  ProfilePoint from, to;
  double (*distance)(const ProfilePoint& p);
};

// A cylinder of radius 24 up to z = 60, and a shoulder of 1 mm that is the fillet of the nose.
double distanceFromShoulder(const ProfilePoint& p) {
  const ProfilePoint v = p - ProfilePoint(25.0, 60.0);
  const double ends = std::min((v - ProfilePoint(-kPassNose, 0.0)).norm(), (v - ProfilePoint(0.0, kPassNose)).norm());
  const double fillet = v.x() <= 0.0 && v.y() >= 0.0 ? std::abs(v.norm() - kPassNose) : ends;
  return std::min({fillet, distanceToLine(p, {24, 0}, {24, 60}), distanceToLine(p, {25, 61}, {25, 100})});
}

// A cone that falls from radius 25 at z = 100 to 24 at z = 0.
double distanceFromCone(const ProfilePoint& p) {
  return distanceToLine(p, {24, 0}, {25, 100});
}

// The centre of the nose is beside the cone by its radius.
ProfilePoint besideCone(double z) {
  const ProfilePoint along = ProfilePoint(1, 100).normalized();
  return ProfilePoint(24.0 + 0.01 * z, z) + kPassNose * ProfilePoint(along.y(), -along.x());
}

std::vector<StraightPass> straightPasses() {
  return {{"a shoulder of 1 mm in four passes", {25.0, -5.0}, {25.0, 60.0}, distanceFromShoulder},
          {"a cone of 1 : 50 in four passes", besideCone(-5.0), besideCone(105.0), distanceFromCone}};
}

// The cost is that of one step.
FidelitySample measured(const StraightPass& pass, const TurningPass& how) {
  TurnedProfile profile(kPassedBar, turnSpacingSetting().standard);
  TurnedSurface surface(profile, 0.02);
  const int steps = static_cast<int>((pass.to - pass.from).norm() / kFeedStep);
  const ProfilePoint step = (pass.to - pass.from) / steps;
  FidelitySample sample;
  const double all = cpuMilliseconds([&] {
    for (int k = kPasses; k-- > 0;) {
      const ProfilePoint from = pass.from + ProfilePoint(k * kPassDepth, 0.0);
      for (int i = 0; i < steps; ++i)
        surface.update(profile, cut(profile, how, from + i * step, from + (i + 1) * step));
    }
  });
  sample.cost = all / (steps * kPasses);
  for (std::size_t i = 0; i < profile.size(); ++i)
    sample.error = std::max(sample.error, pass.distance({profile.radius(i), profile.z(i)}));
  return sample;
}

}  // namespace

std::vector<FidelityCase> turnMethodCases() {
  std::vector<FidelityCase> cases;
  for (const StraightPass& pass : straightPasses()) {
    cases.push_back({pass.name, "closed form", [pass](double value, std::uint64_t, Progress) {
                       TurningPass how;
                       how.noseRadius = kPassNose;
                       how.method = static_cast<TurningMethod>(static_cast<int>(value));
                       how.resolution = turnResolutionSetting().standard;
                       return measured(pass, how);
                     }});
  }
  return cases;
}

std::vector<FidelityCase> turnResolutionCases() {
  std::vector<FidelityCase> cases;
  for (const StraightPass& pass : straightPasses()) {
    cases.push_back({pass.name, "closed form", [pass](double value, std::uint64_t, Progress) {
                       TurningPass how;
                       how.noseRadius = kPassNose;
                       how.method = TurningMethod::Poles;
                       how.resolution = value;
                       return measured(pass, how);
                     }});
  }
  return cases;
}

}  // namespace handwheel
