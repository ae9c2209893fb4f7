// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/HapticPathOptions.h"

#include "base/NumberText.h"
#include "base/ThreadClock.h"
#include "haptics/scene/SceneForces.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

void append(std::string& csv, const Vec3& v) {
  for (int k = 0; k < 3; ++k) csv += ',' + shortestText(v[k] == 0.0 ? 0.0 : v[k]);
}

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

std::size_t HapticPathOptions::ticks() const {
  // A path of whole periods ends with a tick although its times were rounded to decimals.
  return static_cast<std::size_t>(std::floor((to - from) * rate + 1e-6)) + 1;
}

HapticPathResult feel(const HapticPathOptions& run, MeshHaptics scene, Progress progress) {
  SceneForces forces(forceSources(std::move(scene)));
  HapticPathResult felt;
  felt.csv = "t_s,hip_x,hip_y,hip_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contact,tick_us\n";
  std::vector<double> costs;
  const std::size_t ticks = run.ticks();
  TipState tip;
  tip.period = 1.0 / run.rate;
  tip.stiffnessLimit = run.stiffnessLimit;
  tip.dampingLimit = run.dampingLimit;
  for (std::size_t i = 0; i < ticks; ++i) {
    if (i % 1024 == 0) {
      if (progress.cancelled()) return felt;
      progress.set(static_cast<double>(i) / static_cast<double>(ticks));
    }
    const Vec3 before = tip.position;
    tip.time = run.from + static_cast<double>(i) / run.rate;
    tip.position = run.path.at(tip.time).position;
    tip.isRestart = i == 0;
    tip.velocity = tip.isRestart ? Vec3(Vec3::Zero()) : Vec3((tip.position - before) * run.rate);
    ForceOut out;
    out.proxy = tip.position;
    const std::uint64_t start = threadCpuNanoseconds();
    forces.tick(tip, out);
    const double cost = 1e-3 * static_cast<double>(threadCpuNanoseconds() - start);
    const double asked = out.force.norm();
    felt.askedForce = std::max(felt.askedForce, asked);
    felt.cut += asked > run.maxForce ? 1 : 0;
    if (asked > run.maxForce) out.force *= run.maxForce / asked;
    felt.csv += shortestText(tip.time);
    append(felt.csv, tip.position);
    append(felt.csv, out.proxy);
    append(felt.csv, out.force);
    felt.csv += out.isContact ? ",1," : ",0,";
    felt.csv += roundedText(cost) + '\n';
    felt.inContact += out.isContact ? 1 : 0;
    felt.peakForce = std::max(felt.peakForce, out.force.norm());
    costs.push_back(cost);
  }
  felt.ticks = ticks;
  felt.usualMicroseconds = quantile(costs, 0.5);
  felt.slowMicroseconds = quantile(costs, 0.99);
  return felt;
}

}  // namespace handwheel
