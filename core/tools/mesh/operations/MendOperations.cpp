// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/MendOperations.h"

#include "mesh/measure/MeshFidelity.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/SharedParameters.h"

#include <QtGlobal>

namespace handwheel {

std::vector<Operation> mendOperations() {
  return {
      {.id = "back",
       .title = QT_TRANSLATE_NOOP("Tool", "Give a back"),
       .meaning = "Make a thin body of each sheet that has such an outer edge",
       .operands = "LOOPS",
       .parameters = fillParameters()},
      {.id = "cut-and-close",
       .title = QT_TRANSLATE_NOOP("Tool", "Cut and close"),
       .meaning = "Close it across the part, and cut where that crosses",
       .operands = "LOOP",
       .parameters = fillParameters()},
      {.id = "debris",
       .title = QT_TRANSLATE_NOOP("Tool", "Remove debris"),
       .meaning = "Remove all small pieces, or those with these triangles: 7,9",
       .operands = "[TRIANGLES]"},
      {.id = "degenerates",
       .title = QT_TRANSLATE_NOOP("Tool", "Remove triangles without area"),
       .meaning = "Remove triangles without area"},
      {.id = "duplicates",
       .title = QT_TRANSLATE_NOOP("Tool", "Remove duplicate triangles"),
       .meaning = "Remove triangles that are there twice"},
      {.id = "split-nonmanifold",
       .title = QT_TRANSLATE_NOOP("Tool", "Part what only touches"),
       .meaning = "Part what only touches",
       .parameters = {numbersParameter()},
       .formerId = "part"},
      {.id = "two-sides",
       .title = QT_TRANSLATE_NOOP("Tool", "Cut and give two sides"),
       .meaning = "Cut what has one side only until it has two, and close the cuts",
       .parameters = fillParameters()},
      {.id = "near-vertices",
       .title = QT_TRANSLATE_NOOP("Tool", "Merge near vertices"),
       .meaning = "Merge these pairs of vertices; without a list all that are near",
       .operands = "[V:V,...]",
       .parameters = {nearWeldParameter(nearWeldSetting().standard)}},
      {.id = "cut-crossings",
       .title = QT_TRANSLATE_NOOP("Tool", "Cut crossings apart"),
       .meaning = "Cut pairs of crossing triangles apart; all without a list",
       .operands = "[T:T,...]",
       .parameters = {numbersParameter()},
       .formerId = "uncross"},
  };
}

}  // namespace handwheel
