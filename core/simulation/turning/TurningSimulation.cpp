// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/TurningSimulation.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

TurningSimulation::TurningSimulation(TurnedProfile profile, TurnedSurface surface, TurningPass blank, double base,
                                     std::shared_ptr<TurningChannel> channel, std::size_t mostPoints,
                                     TurningFinish finish)
    : m_state(std::make_shared<const TurningState>(profile, std::move(surface))),
      m_profile(std::move(profile)),
      m_hand(std::move(blank), base, mostPoints),
      m_base(base),
      m_channel(std::move(channel)),
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
  if (!changed.isEmpty() || m_hand.isFull() != m_state->isFull) {
    auto state = std::make_shared<TurningState>(m_profile, m_state->surface);
    state->surface.update(m_profile, changed);
    state->finish = m_finish.finish();
    const bool isCutting = m_speed > 0.0 && isDeep(m_state->profile, changed);
    state->fastest = isCutting ? std::max(m_state->fastest, feed) : m_state->fastest;
    state->isCut = m_state->isCut || !changed.isEmpty();
    state->isFull = m_hand.isFull();
    m_state = std::move(state);
  }
  if (inputs.empty()) return;
  const Vec3& hand = inputs.back().tip.position;
  const PatchThreads threads{m_state->surface.threads().get(), std::atan2(hand.y(), hand.x())};
  ProfilePatch patch = patchAround(m_profile, hand.z() - m_base, pass().noseRadius, pass().side, threads);
  patch.simulation = m_number;
  m_channel->patch.write(patch);
}

// Returns true if more than a touch was removed, as in reviews of passes.
bool TurningSimulation::isDeep(const TurnedProfile& before, const TurnedProfile::Range& changed) const {
  for (std::size_t i = changed.first; i < changed.last; ++i) {
    const double outer = before.radius(i) - m_profile.radius(i), inner = m_profile.inner(i) - before.inner(i);
    if (std::max(outer, inner) > TurningPass::kTouch) return true;
  }
  return false;
}

TurnedProfile::Range TurningSimulation::take(const SimulationInput& input) {
  if (input.gesture == 0) return {};
  const TurningPass& made = m_hand.pass();
  TurnedProfile::Range changed;
  const std::size_t added = m_hand.add(input.proxy, input.tip.time, m_speed);
  for (std::size_t i = made.path.size() - added; i < made.path.size(); ++i) {
    const TurnedProfile::Range cutNow = cut(m_profile, made, made.path[i == 0 ? 0 : i - 1], made.path[i]);
    m_finish.add(made, i, m_passNumber, m_profile, cutNow);
    changed.extend(cutNow);
  }
  return changed;
}

}  // namespace handwheel
