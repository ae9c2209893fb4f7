// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/workpiece/WorkpieceSnapshot.h"

namespace handwheel {

// An edit that replaces the setup of a lathe. The setup consists of the chuck, the tailstock, and the tools with their
// offsets.
class LatheSetupEdit : public Edit {
 public:
  explicit LatheSetupEdit(std::shared_ptr<const LatheSetup> setup) : m_setup(std::move(setup)) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override;

 private:
  std::shared_ptr<const LatheSetup> m_setup;
};

// Returns the setup of a workpiece, or the usual one for its bar if there is none.
LatheSetup latheOf(const WorkpieceSnapshot& workpiece);

}  // namespace handwheel
