// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// The exercise that a document is work on, and the attempt at it. Both are as containers have them; their
// meaning is known to document/exercise/StartedWork.h. Both null: the document is no work on an exercise.
struct AssignedExercise {
  std::shared_ptr<const nlohmann::json> description;
  std::shared_ptr<const nlohmann::json> attempt;

  explicit operator bool() const { return description && attempt; }
};

}  // namespace handwheel
