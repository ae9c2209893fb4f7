// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/mesh/repair/RepairJobs.h"

#include <QAction>

namespace handwheel {

class FidelityChoice;
class LoopSelection;

// The actions of the Repair menu. They are also used by keys, buttons and cards.
class RepairActions : public QObject {
  Q_OBJECT

 public:
  RepairActions(LoopSelection& selection, RepairJobs& jobs, HolePreview& preview, const FidelityChoice& fidelity,
                QObject* parent = nullptr);

  void setDocument(MeshTab* document);  // null: no mesh is in view

  QAction* repairAll() { return &m_repairAll; }
  QAction* removeDebris() { return &m_removeDebris; }
  QAction* undoRepair() { return &m_undoRepair; }  // undoes the last repair; used by the suggestion card
  QAction* goOneByOne() { return &m_oneByOne; }
  QAction* repairByVolume() { return &m_byVolume; }  // used by the suggestion card
  QAction* fill() { return &m_fill; }
  QAction* keepOpen() { return &m_keepOpen; }
  QAction* preview() { return &m_showPreview; }
  QAction* next() { return &m_next; }
  QAction* previous() { return &m_previous; }
  QAction* deselect() { return &m_deselect; }
  QList<QAction*> all();

 signals:
  void showLoopRequested(int loop);  // moves the camera to the loop
  void volumeRepairRequested();      // chooses the tool for repair by volume

 private:
  void connectActions();
  void follow();
  void followPreview();
  void followUndo();
  // Enables an action of the document, or disables it with a reason. This is the reason why no job can start, or else
  // the given reason.
  void offerJob(QAction& action, bool isThere, const QString& reason) const;
  bool isTried(const MeshTab& document) const;
  void fillSelected();
  void toggleKeepOpen();
  void step(int direction);

  MeshTab* m_document = nullptr;
  // Key of the hole that is being filled; none if another one was chosen meanwhile. When it is filled, no hole is
  // selected, and the camera stays with the new patch until the user goes on.
  Vertex m_filling = kNone;
  Vertex m_filled = kNone;  // key of the hole filled last, from which the user goes on
  LoopSelection& m_selection;
  RepairJobs& m_jobs;
  HolePreview& m_preview;
  const FidelityChoice& m_fidelity;
  QAction m_repairAll;
  QAction m_removeDebris;
  QAction m_undoRepair;
  QAction m_oneByOne;
  QAction m_byVolume;
  QAction m_fill;
  QAction m_keepOpen;
  QAction m_showPreview;
  QAction m_next;
  QAction m_previous;
  QAction m_deselect;
};

}  // namespace handwheel
