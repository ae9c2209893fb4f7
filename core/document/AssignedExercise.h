// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// The exercise to which a document belongs, and the student's attempt at it. Both are JSON as it is stored in
// containers; document/exercise/StartedWork.h interprets them. Both null: the document does not belong to an exercise.
struct AssignedExercise {
  std::shared_ptr<const nlohmann::json> description;
  std::shared_ptr<const nlohmann::json> attempt;

  explicit operator bool() const { return description && attempt; }
};

}  // namespace handwheel
