// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/HapticPathOptions.h"

#include "base/NumberText.h"
#include "base/ThreadClock.h"
#include "haptics/scene/SceneForces.h"
#include "mesh/structure/CancelPolling.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

void append(std::string& csv, const Vec3& v) {
  for (int k = 0; k < 3; ++k) csv += ',' + shortestText(v[k] == 0.0 ? 0.0 : v[k]);
}

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace

std::size_t HapticPathOptions::ticks() const {
  // A path of whole periods ends with a tick although its times were rounded to decimals.
  return static_cast<std::size_t>(std::floor((to - from) * rate + 1e-6)) + 1;
}

HapticPathTable::HapticPathTable() {
  m_result.csv = "t_s,hip_x,hip_y,hip_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contact,tick_us\n";
}

void HapticPathTable::add(const TipState& tip, const ForceOut& felt, double microseconds, double asked) {
  m_result.csv += shortestText(tip.time);
  append(m_result.csv, tip.position);
  append(m_result.csv, felt.proxy);
  append(m_result.csv, felt.force);
  m_result.csv += felt.isContact ? ",1," : ",0,";
  m_result.csv += roundedText(microseconds) + '\n';
  ++m_result.ticks;
  m_result.inContact += felt.isContact ? 1 : 0;
  m_result.askedForce = std::max(m_result.askedForce, asked);
  m_result.peakForce = std::max(m_result.peakForce, felt.force.norm());
  m_costs.push_back(microseconds);
}

HapticPathResult HapticPathTable::take() {
  m_result.usualMicroseconds = quantile(m_costs, 0.5);
  m_result.slowMicroseconds = quantile(m_costs, 0.99);
  return std::move(m_result);
}

HapticPathResult feel(const HapticPathOptions& run, MeshHaptics scene, Progress progress) {
  SceneForces forces(forceSources(std::move(scene)));
  HapticPathTable table;
  std::size_t cut = 0;
  const std::size_t ticks = run.ticks();
  TipState tip;
  tip.period = 1.0 / run.rate;
  tip.stiffnessLimit = run.stiffnessLimit;
  tip.dampingLimit = run.dampingLimit;
  for (std::size_t i = 0; i < ticks; ++i) {
    if (!pollProgress(i, ticks, progress, 1024)) break;
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
    cut += asked > run.maxForce ? 1 : 0;
    if (asked > run.maxForce) out.force *= run.maxForce / asked;
    table.add(tip, out, cost, asked);
  }
  HapticPathResult felt = table.take();
  felt.cut = cut;
  return felt;
}

}  // namespace handwheel
