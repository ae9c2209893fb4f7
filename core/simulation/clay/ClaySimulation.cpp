// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/clay/ClaySimulation.h"

#include "volume/VolumeReader.h"

#include <limits>

namespace handwheel {

ClaySimulation::ClaySimulation(std::shared_ptr<const ClayState> begin, const ClayBrush& brush,
                               std::shared_ptr<ClayChannel> channel)
    : m_state(std::move(begin)), m_stroke(brush), m_channel(std::move(channel)) {}

void ClaySimulation::step(double, std::span<const SimulationInput> inputs) {
  const VolumeReader reader(m_state->volume);
  for (const SimulationInput& input : inputs) {
    if (input.gesture == 0) continue;
    if (input.isEnd) {
      m_isEnded = true;
    } else {
      m_stroke.move(input.proxy, input.tip.time, reader.normalAt(input.proxy));
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
  SparseVolume volume = m_state->volume;
  std::vector<VoxelIndex> changed;
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<VoxelIndex> blocks = applyDab(volume, dabs[i]);
    changed.insert(changed.end(), blocks.begin(), blocks.end());
  }
  dabs.erase(dabs.begin(), dabs.begin() + static_cast<std::ptrdiff_t>(count));
  if (changed.empty()) return;
  for (const VoxelIndex& block : changed) m_changed.insert({block.x(), block.y(), block.z()});
  auto state = std::make_shared<ClayState>(*m_state);
  state->volume = std::move(volume);
  state->surface.update(state->volume, changed);
  state->changedBlocks = m_changed.size();
  m_state = std::move(state);
  m_isWritten = false;
}

}  // namespace handwheel
