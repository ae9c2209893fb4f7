// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/mesh/MeshDocument.h"
#include "mesh/repair/Repair.h"
#include "panels/defects/DefectList.h"
#include "window/documents/DocumentTab.h"
#include "window/mesh/OperationsOrigin.h"

#include <map>

namespace handwheel {

struct MeshDeviation;

// An open mesh document with its window state. The member `document` hides that of the base class; it refers to the
// same object as a MeshDocument.
struct MeshTab : DocumentTab {
  MeshTab(std::unique_ptr<Document> made, KindUi& of)
      : DocumentTab(std::move(made), of),
        document(static_cast<MeshDocument&>(DocumentTab::document)),
        defectList(document),
        asOpened(document.mesh()) {
    QObject::connect(document.history(), &QUndoStack::indexChanged, &defectList, [this] {
      const auto found = findings.find(presentPoint(document));
      if (found != findings.end()) defectList.setFindings(found->second);
    });
  }

  MeshDocument& document;
  DefectList defectList;
  const HalfEdgeMesh asOpened;                  // shares unchanged pages with the present mesh
  std::shared_ptr<MeshDeviation> deviation;     // the comparison that is shown; null: none
  Vertex selected = kNone;                      // DefectList::keyOf() of the selected loop
  std::shared_ptr<OperationValues> fillChoice;  // the options for filling holes one by one; null until they are needed
  std::optional<HistoryPoint> repairedAt;       // state after the last "Repair all"
  FidelityValues repairedWith;                  // settings of the last "Repair all"
  std::optional<HistoryPoint> fixedAt;  // state after the last "Repair all" or fix of a defect that changed the mesh
  std::map<HistoryPoint, RepairFindings> findings;  // findings after each repair or fix, for undo and redo

  std::size_t faceSlots = document.mesh().faceSlots();  // number of face slots at the last change
  FaceSelection newest;                                 // the faces added by the last change, usually those of a patch

  std::uint64_t changes = 0;            // number of changes of the mesh, including undo and redo
  std::uint64_t changesInFile = 0;      // value of `changes` when the mesh last equalled its file
  std::vector<OperationsOrigin> bases;  // the files from which the command line of the edits can start; the newest last
  // Updates the counters and the newest faces after a change. touched: as in MeshDocument::meshChanged.
  void meshChanged(const std::vector<Face>& touched) {
    ++changes;
    FaceSelection added;
    for (const Face f : touched)
      if (f >= faceSlots && f < document.mesh().faceSlots()) added.add(f);
    faceSlots = document.mesh().faceSlots();
    newest.dropDead(document.mesh());
    if (!added.empty()) newest = added;
  }
  // Stores the findings after a repair or fix of the present mesh.
  void keepFindings() { findings[presentPoint(document)] = defectList.findings(); }
  bool isRepaired() const {
    return repairedAt == presentPoint(document);
  }  // returns true if "Repair all" was the last step
  // Returns true if the last change, or the last redone one, was "Repair all" or the fix of a defect, and it changed
  // something.
  bool isJustRepaired() const { return fixedAt == presentPoint(document); }
  // Returns true if the mesh equals that of the file, which was read without loss. The loops marked to be kept open may
  // differ.
  bool isAsInFile() const { return inFile && document.file().damage.empty() && changes == changesInFile; }
};

}  // namespace handwheel
