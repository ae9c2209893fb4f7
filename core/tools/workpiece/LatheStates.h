// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/lathe/LatheMachine.h"

#include <optional>
#include <utility>
#include <vector>

namespace handwheel {

// The states of a lathe at the versions of a part, for undo and redo. They keep no version alive.
class LatheStates {
 public:
  using Part = std::shared_ptr<const TurnedPart>;

  // Stores the state of the lathe at a version of the part. part: null for the uncut bar.
  void note(const Part& part, const LatheState& state);
  std::optional<LatheState> of(const Part& part) const;  // none: no state is stored; O(parts)

 private:
  std::optional<LatheState> m_ofBar;
  std::vector<std::pair<std::weak_ptr<const TurnedPart>, LatheState>> m_ofParts;
};

}  // namespace handwheel
