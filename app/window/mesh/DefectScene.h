// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QModelIndex>
#include <QObject>

namespace handwheel {

class DefectModel;
class Selection;
class Viewport;
struct OpenMesh;
struct Pick;

// Keeps the viewport in step with the present document: surface, defect marks and selection.
class DefectScene : public QObject {
  Q_OBJECT

 public:
  DefectScene(Viewport& viewport, Selection& selection, DefectModel& defects, QObject* parent = nullptr);

  void setDocument(OpenMesh* document);  // the camera of the one before is kept with it
  void showLoop(int loop);               // flies there
  void showPlace(const QModelIndex& defect);
  void refreshVisibility();  // after OpenMesh::visible was changed

 private:
  int loopAt(const Pick& pick) const;  // also where the hole itself is pointed at, not its rim
  void showSurface();
  void drawLoops();
  void drawDefects();

  Viewport& m_viewport;
  Selection& m_selection;
  DefectModel& m_defects;
  OpenMesh* m_document = nullptr;
};

}  // namespace handwheel
