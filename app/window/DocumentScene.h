// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QModelIndex>
#include <QObject>

namespace handwheel {

class DefectModel;
class HolePreview;
class Selection;
class Viewport;
struct OpenDocument;
struct Pick;

// Keeps the viewport in step with the present document: surface, defect marks, selection and preview.
class DocumentScene : public QObject {
  Q_OBJECT

 public:
  DocumentScene(Viewport& viewport, Selection& selection, HolePreview& preview, DefectModel& defects,
                QObject* parent = nullptr);

  void setDocument(OpenDocument* document);  // the camera of the one before is kept with it
  void showLoop(int loop);                   // flies there
  void showPlace(const QModelIndex& defect);
  void refreshVisibility();  // after OpenDocument::visible was changed

 private:
  int loopAt(const Pick& pick) const;  // also where the hole itself is pointed at, not its rim
  void showSurface();
  void drawLoops();
  void drawDefects();
  void drawPreview();

  Viewport& m_viewport;
  Selection& m_selection;
  HolePreview& m_preview;
  DefectModel& m_defects;
  OpenDocument* m_document = nullptr;
};

}  // namespace handwheel
