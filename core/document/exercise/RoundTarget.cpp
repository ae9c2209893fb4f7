// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/RoundTarget.h"

#include <QtGlobal>

namespace handwheel {

const Operation& roundTargetOperation() {
  static const Operation kOperation = {
      .id = "round-target",
      .title = QT_TRANSLATE_NOOP("Tool", "Round the target"),
      .meaning = "Give the target of an exercise round sizes, as a drawing has them",
      .parameters = {{.property = {.id = "round-target",
                                   .group = {},
                                   .label = QT_TRANSLATE_NOOP("Property", "Diameters and heights to"),
                                   .value = 0.1,
                                   .quantity = Quantity::Length,
                                   .least = 1e-3,
                                   .largest = 10.0},
                      .meaning = "Round diameters, heights and fillets of the target to multiples of this",
                      .word = "MM"},
                     {.property = {.id = "sharp-corners",
                                   .group = {},
                                   .label = QT_TRANSLATE_NOOP("Property", "Sharp corners instead of radii up to"),
                                   .value = 0.0,
                                   .quantity = Quantity::Length,
                                   .least = 0.0,
                                   .largest = 1e3},
                      .meaning = "With --round-target: hollow corners of up to this radius become sharp",
                      .word = "MM"}}};
  return kOperation;
}

Result<ExerciseSubject::RoundedTask> withRoundedTarget(const ExerciseSubject& subject, const ExerciseTask& task,
                                                       const OperationValues& values) {
  return subject.withRoundedTarget(task, values.number("round-target"), values.number("sharp-corners"));
}

}  // namespace handwheel
