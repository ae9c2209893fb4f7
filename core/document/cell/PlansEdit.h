// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Edit.h"
#include "robot/program/RobotPath.h"

namespace handwheel {

// Exchanges what is planned in a cell: configurations, paths and what belongs to them.
class PlansEdit : public Edit {
 public:
  explicit PlansEdit(std::shared_ptr<const CellPlans> plans) : m_plans(std::move(plans)) {}  // not null

  void exchange(Document& document) override;
  std::size_t bytes() const override { return sizeof *this + m_plans->bytes(); }

 private:
  std::shared_ptr<const CellPlans> m_plans;
};

// Error where that is more than a cell can hold, and so than is read of its file: CellError::PlansFull.
Status checkCounts(const CellPlans& plans);

}  // namespace handwheel
