// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/MeshOperations.h"

#include "tools/mesh/operations/BoundaryEditOperations.h"
#include "tools/mesh/operations/DecimateOperation.h"
#include "tools/mesh/operations/DefectFixOperations.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/RepairOperation.h"
#include "tools/mesh/operations/SculptOperations.h"
#include "tools/mesh/operations/SubdivideOperation.h"
#include "tools/mesh/operations/TransformOperations.h"
#include "tools/mesh/voxels/VolumeRepairOperation.h"

#include <QtGlobal>
#include <algorithm>
#include <cassert>

namespace handwheel {
namespace {

// Those without parameters.
std::vector<Operation> plainOperations() {
  return {
      {.id = "delete",
       .title = QT_TRANSLATE_NOOP("Tool", "Delete faces"),
       .meaning = "Remove triangles: 1-20,33",
       .operands = "TRIANGLES"},
      {.id = "keep-open",
       .title = QT_TRANSLATE_NOOP("Tool", "keep open"),
       .meaning = "Mark openings to be kept open",
       .operands = "LOOPS"},
      {.id = "no-longer-open",
       .title = QT_TRANSLATE_NOOP("Tool", "no longer keep open"),
       .meaning = "Remove such marks",
       .operands = "LOOPS"},
      {.id = "add",
       .title = QT_TRANSLATE_NOOP("Tool", "Add a mesh"),
       .meaning = "Add the mesh of another file to this one, at its own position",
       .operands = "FILE"},
      {.id = "unit",
       .title = QT_TRANSLATE_NOOP("Tool", "Change the unit"),
       .meaning = "Unit in which lengths are shown: mm, cm, m, in",
       .operands = "U"},
  };
}

std::vector<Operation> allOperations() {
  std::vector<Operation> all;
  const auto add = [&all](std::vector<Operation> some) {
    all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  };
  add(transformOperations());
  add({fillOperation(), repairOperation()});
  add(defectFixOperations());
  add({volumeRepairOperation()});
  add({decimateOperation(), subdivideMeshOperation()});
  add(boundaryEditOperations());
  add(sculptOperations());
  add(plainOperations());
  return all;
}

}  // namespace

std::span<const Operation> meshOperations() {
  static const std::vector<Operation> all = allOperations();
  return all;
}

const Operation* findMeshOperation(std::string_view verb) {
  const auto all = meshOperations();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Operation& o) {
    return o.id == verb || (!o.formerId.empty() && o.formerId == verb);
  });
  return found == all.end() ? nullptr : &*found;
}

const Operation& meshOperation(std::string_view verb) {
  const Operation* found = findMeshOperation(verb);
  assert(found);
  return *found;
}

}  // namespace handwheel
