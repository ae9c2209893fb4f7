// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QModelIndex>
#include <QObject>

namespace handwheel {

class DefectModel;
class MeshLayer;
class LoopSelection;
class Viewport;
struct MeshTab;
struct Pick;

// Shows the mesh of the current document with its defects in the viewport. It keeps the surface, defect marks and
// selection up to date.
class DefectScene : public QObject {
  Q_OBJECT

 public:
  DefectScene(Viewport& viewport, MeshLayer& layer, LoopSelection& selection, DefectModel& defects,
              QObject* parent = nullptr);

  void setDocument(MeshTab* document);         // stores the camera with the previous document
  void showLoop(int loop);                     // moves the camera to the loop
  void showDefect(const QModelIndex& defect);  // moves the camera to the defect if it is not well visible
  void markChosen(const QModelIndex& defect);  // marks the defect among the others of its kind; invalid: none
  void refreshVisibility();                    // to be called when MeshTab::visible was changed

 private:
  int loopAt(const Pick& pick) const;  // returns the loop whose rim or hole is under the cursor
  void drawLoops();
  bool isChosen(Face f) const;
  void flyTo(const Box& box, const Vec3& outward);
  void drawDefects();

  Viewport& m_viewport;
  MeshLayer& m_layer;
  LoopSelection& m_selection;
  DefectModel& m_defects;
  MeshTab* m_document = nullptr;
  std::vector<Face> m_chosen;  // sorted; faces of the defect that is selected in the list
};

}  // namespace handwheel
