// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/HandGuidingTool.h"
#include "tools/cell/JointDragTool.h"
#include "tools/cell/PlaceBodyTool.h"
#include "window/cell/CellBodies.h"
#include "window/cell/CellCollisions.h"
#include "window/cell/CellContactMarks.h"
#include "window/cell/CellPaths.h"
#include "window/cell/CellReachOutline.h"
#include "window/cell/CellRobots.h"
#include "window/cell/PartSurfaces.h"
#include "window/cell/PathDock.h"
#include "window/cell/PathGuides.h"
#include "window/cell/ToolCamera.h"
#include "window/cell/proximity/ProximityDock.h"
#include "window/kinds/RigidPartsUi.h"

#include <QElapsedTimer>
#include <QTimer>
#include <map>

namespace handwheel {

class RobotCellKind;
struct Pick;

// The user interface of robot cells. It contains the list of bodies and the joint sliders, and drags the robots and the
// bodies.
class RobotCellUi : public RigidPartsUi {
  Q_OBJECT

 public:
  RobotCellUi(const WindowContext& window, RobotCellKind& kind);

  QString panelTitle() const override { return tr("Cell"); }
  QString panelIcon() const override { return QStringLiteral("kind-cell"); }
  QWidget* panel() override { return m_panel; }
  QString menuTitle() const override { return tr("&Cell"); }
  QList<QAction*> menu() override;
  QList<QAction*> toolBar() override;
  QMenu* menuAt(const QPointF& position) override;
  void setDocument(DocumentTab* document) override;
  void forget(DocumentTab* document) override;
  void refreshVisibility() override;
  void showPreview(const ToolPreview& preview) override;
  std::vector<Property> listedProperties(const Document& document) const override;
  std::vector<StartAction> startActions() const override;
  void begin(const QString& startAction) override;
  std::vector<ToolDescriptor> tools() override;
  Suggestion suggestion() override;
  QString statistics() const override;
  QString openedText(const DocumentTab& document) const override;

 private:
  std::unique_ptr<Tool> handTool();
  std::unique_ptr<Tool> processTool();
  std::unique_ptr<Tool> handGuidingTool();
  std::unique_ptr<Tool> ikSolutionsTool();
  std::unique_ptr<Tool> placeBodyTool();
  std::unique_ptr<Tool> faceMateTool();
  HeldApproachServices approachServices();
  PlaceBodyServices placeServices();
  std::optional<RobotCellPick> pickCell(const Ray& ray) const;
  std::vector<Property> panelProperties(const Document& document) const override;
  std::map<std::string, bool> foldingGroups(const Document& document) const override;
  bool takeEdit(const std::string& id, const PropertyValue& value, bool stillDragging) override;
  DisplayModel displayed(const Document& document) const override;
  BodyPointer placedBody(BodyId id) const;
  std::optional<Body> shownBody(const Document& document) const;
  QWidget* makePanel();
  void say(Message message);
  void showRobots();
  void showReplay(const std::shared_ptr<const DisplayModel>& model, const std::vector<CellCollision>& collisions);
  void takeShownPose();
  void markShown(DisplayModel& shown, const JointValues& joints,
                 const Body* moved = nullptr);  // Marks the collisions of a model that a tool shows
  void select(const Pick& pick);
  void followRow(bool isChosen);  // isChosen: true if the user chose the row
  std::string selectedRobot() const;
  void selectRobot(std::uint32_t link);
  void selectRobotToPlace(std::size_t number);
  void markSelected(bool isCovered);
  void lookAgain();
  void reveal(BodyId id, bool isNew);

  // The latest messages about a document, which are numbered from 1 in the order in which they are shown.
  struct SaidLast {
    std::uint64_t number = 0, news = 0;  // Numbers of the last message and of the last information
    QString title = {};
  };

  CellBodies m_bodies;
  CellCollisions m_collisions;
  CellContactMarks* const m_contacts;  // A child object
  CellTargets m_targets;
  CellRobots m_robots;
  CellReachOutline m_reach;
  ToolCamera m_toolCamera;
  CellPaths m_paths;
  PathDock m_pathDock;
  ProximityDock m_proximity;
  PartSurfaces m_surfaces;
  PathGuides m_guides;
  QPointer<QWidget> m_panel;
  QElapsedTimer m_clock;
  QTimer m_replayFields;      // Runs until the fields show the joint values of the time line
  bool m_isReplayed = false;  // True if the view shows the robot on a path
  std::map<const DocumentTab*, std::vector<HandGuidingTrial>> m_trials;
  // The settings of the force near objects that a hand holds, for all tools and documents
  const std::shared_ptr<ApproachSettings> m_approach = std::make_shared<ApproachSettings>();
  bool m_showsRow = true;         // True if the panel shows the selected row of the plans instead of the body
  bool m_isCovered = false;       // True if the selected body was covered at the last test
  std::optional<Body> m_dragged;  // The dragged body at its present pose
  std::map<const Document*, SaidLast> m_said;
};

}  // namespace handwheel
