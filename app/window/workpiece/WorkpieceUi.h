// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/turning/TurningForce.h"
#include "window/kinds/CompanionFiles.h"
#include "window/kinds/RigidPartsUi.h"
#include "window/workpiece/DimensionsView.h"
#include "window/workpiece/LatheView.h"
#include "window/workpiece/ReplayDock.h"
#include "window/workpiece/TargetActions.h"
#include "window/workpiece/ThreadAction.h"
#include "window/workpiece/program/ProgramDock.h"

namespace handwheel {

class TurnTool;
struct TurningTask;

// The user interface of workpieces, with their panel, commands and tools.
class WorkpieceUi : public RigidPartsUi, public CompanionFiles {
  Q_OBJECT

 public:
  explicit WorkpieceUi(const WindowContext& window);

  // Opens a document. A new document starts with the chord tolerance from the settings of the user; later, a property
  // of the document changes it.
  std::unique_ptr<DocumentTab> open(std::unique_ptr<Document> document) override;
  void setDocument(DocumentTab* document) override;
  void forget(DocumentTab* document) override;
  QWidget* panel() override { return m_panel; }
  QList<QAction*> menu() override {
    return QList<QAction*>{m_thread.action()} + m_target.actions() +
           QList<QAction*>{m_dimensions.action(), m_program.action(), m_replay.action()};
  }
  bool isSettled() const override {
    return RigidPartsUi::isSettled() && m_target.isSettled() && m_dimensions.isSettled() && m_program.isSettled() &&
           m_replay.isSettled() && m_loads.isIdle() && m_sections.isIdle();
  }
  void refreshVisibility() override;
  bool take(const QString& path) override { return m_program.take(path); }
  std::optional<Offer> companionOffer(const QString& path) const override;
  QString companionFilter() const override;
  QString unsavedBeside(const DocumentTab& document) const override { return m_program.unsavedOf(document); }
  void saveBeside(DocumentTab& document, std::function<void(bool)> ended) override {
    m_program.saveOf(document, std::move(ended));
  }
  std::vector<StartAction> startActions() const override;
  QString panelTitle() const override { return tr("Stock"); }
  QString panelIcon() const override { return QStringLiteral("kind-workpiece"); }
  QString menuTitle() const override { return tr("&Workpiece"); }
  std::vector<ToolDescriptor> tools() override;
  Suggestion suggestion() override;
  QString statistics() const override;
  std::optional<Ray> sectionAxis() const override { return Ray{Vec3::Zero(), Vec3::UnitZ()}; }  // the axis of turning
  QString openedText(const DocumentTab& document) const override;

 protected:
  DisplayModel displayed(const Document& document) const override;

 private:
  QWidget* makePanel();
  std::unique_ptr<Tool> turnTool();
  std::unique_ptr<Tool> latheTool();
  void followTool();
  void warnOfFeed(const TurnTool& tool);
  void watchLoads();
  void prepareSection();
  void warnOfLoads(DocumentTab* loaded, const TurningTask& task, double force, double power);
  void followSize();
  void tellParted();
  void explainLocks();

  TargetActions m_target;
  DimensionsView m_dimensions;
  LatheView m_lathe;
  ThreadAction m_thread;
  ProgramDock m_program;
  ReplayDock m_replay;
  QPointer<QWidget> m_panel;
  JobRunner m_loads;                               // computes the loads of an exercise's passes on its lathe
  JobRunner m_sections;                            // computes the exact sections of passes by hand
  const DocumentTab* m_parted = nullptr;           // the document of m_partedPart
  std::shared_ptr<const TurnedPart> m_partedPart;  // the part when its pieces were last counted
  // The part of each document whose passes have been checked.
  std::map<const DocumentTab*, std::shared_ptr<const TurnedPart>> m_loadedParts;
  std::size_t m_passes = 0;                // number of passes of the current document when followTool() last ran
  bool m_isLathe = false;                  // true: the tool of the lathe runs
  std::shared_ptr<TurningChannel> m_felt;  // channel of the tool whose force source is in the haptic scene; null: none
  TurningTool m_feltSettings;
  double m_feltBase = 0.0;  // mm, TurnTool::base()
  const DocumentTab* m_sized = nullptr;
  StockCylinder m_size;  // last shown size of m_sized
};

}  // namespace handwheel
