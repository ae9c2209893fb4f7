// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/workpiece/WorkpieceSnapshot.h"

namespace handwheel {

// An edit that replaces the target of a workpiece; null removes it.
class TargetEdit : public Edit {
 public:
  explicit TargetEdit(std::shared_ptr<const WorkpieceTarget> target) : m_target(std::move(target)) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override;

 private:
  std::shared_ptr<const WorkpieceTarget> m_target;
};

}  // namespace handwheel
