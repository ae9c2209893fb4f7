// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/TurningSimulation.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace handwheel {

namespace {

// Where a straight way comes nearer to the axis than both of its ends, as a share of it; none: nowhere.
std::optional<double> nearestToAxis(const Vec3& from, const Vec3& to) {
  const Eigen::Vector2d way = (to - from).head<2>();
  const double share = -from.head<2>().dot(way) / way.squaredNorm();
  return share > 0.0 && share < 1.0 ? std::optional(share) : std::nullopt;  // NaN: it goes along the axis
}

}  // namespace

TurningSimulation::TurningSimulation(TurnedProfile profile, TurnedSurface surface, TurningPass blank, double base,
                                     std::shared_ptr<TurningChannel> channel, std::size_t mostPoints,
                                     TurningFinish finish)
    : m_state(std::make_shared<const TurningState>(profile, std::move(surface))),
      m_profile(std::move(profile)),
      m_pass(std::move(blank)),
      m_base(base),
      m_channel(std::move(channel)),
      m_mostPoints(mostPoints),
      m_finish(m_profile, std::move(finish.before)),
      m_passNumber(finish.pass),
      m_speed(finish.speed),
      m_number(++m_channel->simulations) {
  auto state = std::make_shared<TurningState>(*m_state);
  state->finish = m_finish.finish();
  m_state = std::move(state);
}

void TurningSimulation::step(double, std::span<const SimulationInput> inputs) {
  TurnedProfile::Range changed;
  double feed = 0.0;
  for (const SimulationInput& input : inputs) {
    changed.extend(take(input));
    feed = std::max(feed, m_finish.feed());
  }
  if (!changed.isEmpty() || isFull() != m_state->isFull) {
    auto state = std::make_shared<TurningState>(m_profile, m_state->surface);
    state->surface.update(m_profile, changed);
    state->finish = m_finish.finish();
    const bool isCutting = m_speed > 0.0 && isDeep(m_state->profile, changed);
    state->fastest = isCutting ? std::max(m_state->fastest, feed) : m_state->fastest;
    state->isCut = m_state->isCut || !changed.isEmpty();
    state->isFull = isFull();
    m_state = std::move(state);
  }
  if (inputs.empty()) return;
  const Vec3& hand = inputs.back().tip.position;
  const PatchThreads threads{m_state->surface.threads().get(), std::atan2(hand.y(), hand.x())};
  ProfilePatch patch = patchAround(m_profile, hand.z() - m_base, m_pass.noseRadius, m_pass.side, threads);
  patch.simulation = m_number;
  m_channel->patch.write(patch);
}

// Whether more than a touch has gone. As reviews of passes see it.
bool TurningSimulation::isDeep(const TurnedProfile& before, const TurnedProfile::Range& changed) const {
  for (std::size_t i = changed.first; i < changed.last; ++i) {
    const double outer = before.radius(i) - m_profile.radius(i), inner = m_profile.inner(i) - before.inner(i);
    if (std::max(outer, inner) > TurningPass::kTouch) return true;
  }
  return false;
}

// Places of a hand that passes the axis are on both sides of it: what is cut goes through it, not from radius to
// radius.
TurnedProfile::Range TurningSimulation::take(const SimulationInput& input) {
  if (input.gesture == 0) return {};
  const Vec3 to = input.proxy;
  const double time = input.tip.time;
  TurnedProfile::Range changed;
  if (const auto share = m_pass.path.empty() ? std::nullopt : nearestToAxis(m_place, to))
    changed = add(m_place + *share * (to - m_place), m_time + *share * (time - m_time));
  changed.extend(add(to, time));
  m_place = to;
  m_time = time;
  return changed;
}

TurnedProfile::Range TurningSimulation::add(const Vec3& place, double time) {
  if (isFull()) return {};
  const ProfilePoint tool(place.head<2>().norm(), place.z() - m_base);
  const ProfilePoint from = m_pass.path.empty() ? tool : m_pass.path.back();
  if (m_pass.path.empty()) m_begin = time;
  m_pass.times.push_back(std::max(time - m_begin, m_pass.times.empty() ? 0.0 : m_pass.times.back()));
  m_pass.path.push_back(tool);
  if (m_speed > 0.0) m_pass.speeds.push_back(m_speed);
  const TurnedProfile::Range changed = cut(m_profile, m_pass, from, tool);
  m_finish.add(m_pass, m_pass.path.size() - 1, m_passNumber, m_profile, changed);
  return changed;
}

}  // namespace handwheel
