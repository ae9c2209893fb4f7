// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Edit.h"
#include "robot/program/RobotPath.h"

namespace handwheel {

// Edit that exchanges the plans of a cell: configurations, paths, frames, targets and tools.
class PlansEdit : public Edit {
 public:
  explicit PlansEdit(std::shared_ptr<const CellPlans> plans) : m_plans(std::move(plans)) {}  // plans: not null

  void exchange(Document& document) override;
  std::size_t bytes() const override { return sizeof *this + m_plans->bytes(); }

 private:
  std::shared_ptr<const CellPlans> m_plans;
};

// Returns the error CellError::PlansFull if the plans have more entries than a cell can hold, as reading a file would
// refuse them.
Status checkCounts(const CellPlans& plans);

}  // namespace handwheel
