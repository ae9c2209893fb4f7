// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/clay/ClaySimulation.h"

#include "volume/VolumeSampler.h"

#include <limits>

namespace handwheel {

namespace {

std::vector<VoxelIndex> paint(ClayState& state, std::span<const ClayDab> dabs) {
  const bool isUsed = state.mask && state.mask->fits(state.volume);
  auto mask = std::make_shared<ClayMask>(isUsed ? *state.mask : ClayMask(state.volume));
  std::vector<VoxelIndex> changed;
  for (const ClayDab& dab : dabs) {
    const std::vector<VoxelIndex> blocks = mask->paint(dab);
    changed.insert(changed.end(), blocks.begin(), blocks.end());
  }
  state.mask = mask->isFree() ? nullptr : std::move(mask);
  return changed;
}

std::vector<VoxelIndex> shape(ClayState& state, std::span<const ClayDab> dabs) {
  std::vector<VoxelIndex> changed;
  for (const ClayDab& dab : dabs) {
    const std::vector<VoxelIndex> blocks = applyDab(state.volume, dab, state.mask.get());
    changed.insert(changed.end(), blocks.begin(), blocks.end());
  }
  if (!changed.empty()) state.surface.update(state.volume, changed);
  return changed;
}

}  // namespace

ClaySimulation::ClaySimulation(std::shared_ptr<const ClayState> begin, const ClayBrush& brush,
                               std::shared_ptr<ClayChannel> channel)
    : m_state(std::move(begin)), m_stroke(brush), m_channel(std::move(channel)) {}

void ClaySimulation::step(double, std::span<const SimulationInput> inputs) {
  const VolumeSampler sampler(m_state->volume);
  for (const SimulationInput& input : inputs) {
    if (input.gesture == 0) continue;
    if (input.isEnd) {
      m_isEnded = true;
    } else {
      m_stroke.move(input.proxy, input.tip.time, sampler.normalAt(input.proxy), input.pressure);
    }
  }
  apply(kMostDabs);
  if (m_isEnded && m_stroke.dabs().empty() && !m_state->isComplete) {
    auto complete = std::make_shared<ClayState>(*m_state);
    complete->isComplete = true;
    m_state = std::move(complete);
    m_isWritten = false;
  }
  if (m_isWritten) return;
  m_channel->patch.write({m_state});
  m_isWritten = true;
}

void ClaySimulation::finish() {
  apply(std::numeric_limits<std::size_t>::max());
}

void ClaySimulation::apply(std::size_t most) {
  std::vector<ClayDab>& dabs = m_stroke.dabs();
  const std::size_t count = std::min(most, dabs.size());
  if (count == 0) return;
  const std::span<const ClayDab> next(dabs.data(), count);  // all of one action
  auto state = std::make_shared<ClayState>(*m_state);
  const std::vector<VoxelIndex> changed =
      next.front().action == ClayAction::Mask ? paint(*state, next) : shape(*state, next);
  dabs.erase(dabs.begin(), dabs.begin() + static_cast<std::ptrdiff_t>(count));
  if (changed.empty()) return;
  for (const VoxelIndex& block : changed) m_changed.insert({block.x(), block.y(), block.z()});
  state->changedBlocks = m_changed.size();
  m_state = std::move(state);
  m_isWritten = false;
}

}  // namespace handwheel
