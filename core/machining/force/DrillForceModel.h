// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/CuttingForceModel.h"

#include <memory>

namespace handwheel {

// The law of a twist drill, from a law of turning for the same material.
class DrillForceModel : public CuttingForceModel {
 public:
  // turning: must not be null.
  explicit DrillForceModel(std::unique_ptr<const CuttingForceModel> turning) : m_turning(std::move(turning)) {}

  CutForces at(const CutConditions& cut) const noexcept override { return m_turning->onDrill(cut); }
  CutForces onDrill(const CutConditions& cut) const noexcept override { return m_turning->onDrill(cut); }
  bool covers(const CutConditions& cut) const noexcept override {
    return m_turning->covers({cut.depth, 0.5 * cut.feed, cut.speed});
  }

  const CuttingForceModel& turning() const { return *m_turning; }

 private:
  std::unique_ptr<const CuttingForceModel> m_turning;
};

}  // namespace handwheel
