// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/DefectFixOperations.h"

#include "mesh/measure/MeshFidelity.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/SharedParameters.h"

#include <QtGlobal>

namespace handwheel {

namespace {

Operation thickenOperation() {
  std::vector<Parameter> parameters = fillParameters();
  parameters.insert(parameters.begin(), thicknessParameter());
  return {.id = "back",
          .title = QT_TRANSLATE_NOOP("Tool", "Thicken sheets"),
          .meaning =
              "Thicken each sheet with such an outer boundary to a thin body, which grows to the side opposite "
              "to the normals",
          .operands = "LOOPS",
          .parameters = std::move(parameters)};
}

}  // namespace

std::vector<Operation> defectFixOperations() {
  return {
      thickenOperation(),
      {.id = "cut-and-close",
       .title = QT_TRANSLATE_NOOP("Tool", "Cut and close"),
       .meaning = "Close it across the part, and cut where the patch intersects",
       .operands = "LOOP",
       .parameters = fillParameters()},
      {.id = "debris",
       .title = QT_TRANSLATE_NOOP("Tool", "Remove debris"),
       .meaning = "Remove all debris, as 'repair --remove-debris' does, or the pieces with these triangles: 7,9",
       .operands = "[TRIANGLES]"},
      {.id = "degenerates",
       .title = QT_TRANSLATE_NOOP("Tool", "Remove degenerate triangles"),
       .meaning = "Remove all degenerate triangles, or these and those connected with them: 7-9,12",
       .operands = "[TRIANGLES]"},
      {.id = "duplicates",
       .title = QT_TRANSLATE_NOOP("Tool", "Remove duplicate triangles"),
       .meaning = "Remove all duplicate triangles, or those that lie on these: 7-9,12",
       .operands = "[TRIANGLES]"},
      {.id = "split-nonmanifold",
       .title = QT_TRANSLATE_NOOP("Tool", "Separate touching parts"),
       .meaning = "Move apart vertices that must not be welded: at edges with more than two triangles, and at single "
                  "vertices; "
                  "all, or those at the places of these vertices: 7,9",
       .operands = "[VERTICES]",
       .parameters = {numbersParameter()},
       .formerId = "part"},
      {.id = "two-sides",
       .title = QT_TRANSLATE_NOOP("Tool", "Make two-sided"),
       .meaning = "Cut one-sided surfaces until they have two sides, and close the cuts: all, or the parts with these "
                  "vertices: 7,9",
       .operands = "[VERTICES]",
       .parameters = fillParameters()},
      {.id = "reverse",
       .title = QT_TRANSLATE_NOOP("Tool", "Reverse faces"),
       .meaning = "Reverse the shells that have these triangles: 7,9; without a list the bodies that are inside out",
       .operands = "[TRIANGLES]"},
      {.id = "orient",
       .title = QT_TRANSLATE_NOOP("Tool", "Orient consistently"),
       .meaning =
           "Reverse single triangles so that neighbours agree, the fewest in each part; or exactly these: 7-9,12",
       .operands = "[TRIANGLES]"},
      {.id = "near-vertices",
       .title = QT_TRANSLATE_NOOP("Tool", "Merge near vertices"),
       .meaning = "Merge these pairs of vertices; without a list all near pairs",
       .operands = "[V:V,...]",
       .parameters = {nearWeldParameter(nearWeldSetting().standard)}},
      {.id = "cut-crossings",
       .title = QT_TRANSLATE_NOOP("Tool", "Resolve self-intersections"),
       .meaning = "Cut pairs of intersecting triangles apart and join the rest; without a list all",
       .operands = "[T:T,...]",
       .parameters = {numbersParameter()},
       .formerId = "uncross"},
      {.id = "unite",
       .title = QT_TRANSLATE_NOOP("Tool", "Unite bodies"),
       .meaning = "Make one body of those that intersect, and remove what lies inside of it",
       .parameters = {numbersParameter()}},
  };
}

}  // namespace handwheel
