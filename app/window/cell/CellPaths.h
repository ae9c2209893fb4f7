// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/MessageBar.h"
#include "tools/cell/ProcessPathOperation.h"
#include "tools/cell/path/PathExport.h"
#include "tools/cell/path/PlanOperation.h"
#include "tools/cell/path/ProgramChoices.h"
#include "tools/cell/path/ProgramFrames.h"
#include "window/cell/PathChecks.h"
#include "window/cell/PlanTree.h"

#include <QAction>
#include <QMenu>
#include <QPointer>
#include <map>

class QLabel;

namespace handwheel {

class CellRobots;
struct OptimisedPath;
class PathLayer;
struct RobotSemantics;
class RobotCellDocument;

// The list of the plans of a robot cell and its actions. It stores configurations, targets and frames, plans paths
// through them, edits the waypoints of paths, and verifies and shows paths. The path of the selected row, or the only
// path, is the present one if it belongs to the robot that is planned for.
class CellPaths : public QObject {
  Q_OBJECT

 public:
  // selected: returns the selected body, or null unless exactly one is selected.
  CellPaths(const WindowContext& parts, CellCollisions& collisions, CellTargets& targets, CellRobots& robots,
            std::function<BodyPointer()> selected, QObject* parent);
  ~CellPaths() override;

  void setDocument(DocumentTab* document);
  void forget(const DocumentTab* document);
  // Actions, grouped by purpose.
  QList<QAction*> ofConfigurations() { return {&m_store, &m_storeTarget, &m_storeFrame, &m_go, &m_workIn}; }
  QList<QAction*> ofPaths() {
    return {&m_plan, &m_again, &m_optimise, &m_insert, &m_here, &m_up, &m_down, &m_straight};
  }
  QList<QAction*> ofPrograms() { return {&m_export, &m_import, &m_declareFrame}; }
  QList<QAction*> ofVerification() { return {&m_verify, &m_verifyAll, &m_pairs, &m_semantics}; }
  QList<QAction*> ofRows() { return {&m_rename, &m_remove}; }
  QAction* choosing() { return &m_choose; }  // The action that chooses the robot
  QList<QAction*> buttons() {
    return {&m_store, &m_storeTarget, &m_plan, &m_verify, &m_export};
  }  // Actions of the panel
  QMenu& menu() { return *m_menu; }
  // Plans a path along a curve on a part (processPathOperation()). surface: the surface of the part; null: it is
  // computed.
  void planProcess(const OperationValues& values, std::shared_ptr<const PartSurface> surface);
  // Returns the results for the path of the selected row, as read-only fields, and its clearance. The result is empty
  // if the row is no path.
  std::vector<Property> resultProperties() const;
  // Returns the settings by which the selected path was planned along a curve on a part. The result is empty if the
  // path follows no curve.
  std::vector<Property> processProperties() const;
  // Plans the path of the selected row anew with one of processProperties() changed. Returns false if no property has
  // this id.
  bool takeProcessEdit(const std::string& id, const PropertyValue& value, bool stillDragging);
  // Adds the configuration of the document to the path of the selected row, after the selected waypoint or at the end,
  // or begins a path with it.
  void addWaypoint();
  PlanTree* tree() const { return m_tree; }    // Owned by the window
  QLabel* detail() const { return m_detail; }  // Full description of the selected row; owned by the window
  void setVisible(bool isVisible);             // Applies to the line of the path in the view

  // Sets the joint values that the view shows instead of the document's while a path is played; nothing: those of the
  // document. Configurations, waypoints, targets and frames are stored from the displayed values.
  void setShownJoints(std::optional<JointValues> joints) { m_shownJoints = std::move(joints); }

  bool showsOtherJoints() const { return m_shownJoints.has_value(); }
  // Returns the joint values of the cell as displayed in the view.
  const JointValues& seenJoints(const RobotCellDocument& of) const;

  const NamedTarget* target() const;  // Target of the selected row; null: the row is no target
  const NamedFrame* frame() const;    // Frame of the selected row; null: the row is no frame
  // Return the present path, and its latest valid result; null if there is none.
  const RobotPath* path() const;
  std::shared_ptr<const CheckedPath> checked() const;
  std::shared_ptr<const CellScene> scene() const { return m_collisions.scene(); }
  const CellPlans& plans() const;

 signals:
  void rowChanged();   // Emitted when another row is selected
  void pathChanged();  // Emitted when the present path or its results have changed
  void robotSent();    // Emitted when the robot was moved to a configuration, waypoint or target, and should be shown
  void collisionChosen(std::size_t number);  // number: index of a collision of the present path in stretchesOf()
  void message(const handwheel::Message& message);

 private:
  RobotCellDocument& cell() const;
  const JointValues& seenJoints() const { return seenJoints(cell()); }
  CellPlacement seenPlacement() const;
  void connectActions();
  static RobotCellDocument& cellIn(DocumentTab& tab);
  // Returns true if the cell is unchanged since the scene was made from it.
  static bool isUnchanged(DocumentTab& tab, const CellScene& scene, const RobotCellSnapshot& before);
  // Makes an edit of the plans. Returns false, after a report, if there are too many entries.
  bool commit(DocumentTab& tab, const QString& text, CellPlans plans);
  bool commit(const QString& text, CellPlans plans) { return commit(*m_document, text, std::move(plans)); }
  void select(const DocumentTab& tab, const PlanTree::Entry& entry);  // Selects the entry if the document is in view
  void store();
  void storeTarget();
  void setTargetHere(const std::string& name);
  void setConfigurationHere(const std::string& name);
  void storeFrame();
  void setFrameHere(const std::string& name);
  void workIn(const std::string& name);  // Chooses the frame in which poses are shown; if it is chosen already, none is
  BodyPointer bodyForTargets() const;    // The body to which new targets are attached; null: none
  std::map<std::string, QString> frameRemarks() const;
  void goTo(const PlanTree::Entry& entry);
  void goToTarget(const std::string& name);
  void askForPath();
  void plan(const OperationValues& values);
  void planAgain();
  void optimise();
  void takeOptimised(DocumentTab& tab, const OptimisedPath& optimised);
  // again: repeats the planning for the cell as it is at that time.
  void startPlanning(std::vector<Waypoint> waypoints, const RouteSettings& settings, const std::string& name,
                     const QString& text, std::function<void()> again);
  using Planning = std::function<Result<PlannedPath>(const CellScene& scene, const RobotCellSnapshot& cell, Progress)>;
  static Planning processPlanning(const OperationValues& values, std::shared_ptr<const PartSurface> surface,
                                  const std::optional<Pose>& chosenAt);
  // A planning job and its completion.
  struct PlanRequest {
    std::string name;  // Name of the path
    QString text;      // Undo text, with %1 for the name
    std::function<void()> again;
    std::function<void()> ended = {};  // Called before the result is taken, or when planning ends without one
    const void* owner = nullptr;       // Owner of the job; null: the document
    std::string part = {};  // The part whose curve a new path follows; empty: none, or the part of the existing path
  };
  void startPlanning(Planning planning, PlanRequest request);
  // Calls a function that needs scene(): at once, or as soon as the cell is prepared. The function is not called if
  // another document is in view by then.
  void whenPrepared(const std::function<void()>& then);
  // The settings with which a path along a curve is being planned. The address of the object identifies the planning
  // job.
  struct WantedProcess {
    std::string path;
    OperationValues values;
    std::uint64_t number = 0;  // Value of m_remakes at its start
  };
  const WantedProcess* wanted(const std::string& path) const;  // Null: no job for this path of the document in view
  void remakeProcess(const std::string& name, const OperationValues& values);
  void takePlanned(DocumentTab& tab, PlannedPath made, const std::optional<RobotPath>& before, const QString& text);
  void reportChanged(DocumentTab& tab, const std::string& path, const std::function<void()>& again);
  void insertHere();
  void insertAt(std::size_t behind);  // Inserts a waypoint into the present path
  void setWaypointHere();
  void moveWaypoint(int by);
  void setStraight(bool isStraight);
  void removeCurrent();
  void rename(const PlanTree::Entry& entry, const QString& name);
  // named: an entry that the message offers to rename.
  void reportStored(const DocumentTab& tab, const QString& title, const QString& detail,
                    std::optional<PlanTree::Entry> named = {});
  void showSelected();  // Shows the selected row in the view
  void showDetail();
  void askForPairs();
  void readSemantics(const QString& file);
  void reportSemantics(const DocumentTab& tab, const RobotSemantics& read, const QString& file, const QString& robot);
  void requestProgram();
  void askForProgram(OutdatedPath outdated);
  // The path to write as a program, in its state at the time of the request.
  struct ProgramRequest {
    RobotPath path;
    OutdatedPath outdated;
    ProgramChoices choices = {};
  };
  bool choosePath(const std::string& name);
  void exportAs(const QString& file, const PostProcessor& ofType, const ProgramRequest& request);
  void exportProgram(const PostProcessor& post, const QString& file, const ProgramRequest& request);
  void reportRemoved(const QString& configuration, const std::vector<std::string>& paths);
  void reportNotWritten(const std::string& path);
  // Offers to write the program without what the language does not have. tab: null if it was closed.
  void reportRefused(const DocumentTab* tab, const Error& error, const PostProcessor& post, const QString& file,
                     const ProgramRequest& request);
  // tab: null if it was closed.
  void reportWritten(const DocumentTab* tab, const WrittenProgram& written, const PostProcessor& post,
                     const QString& file, const CheckedPath& checked, std::size_t leftOut);
  void importProgram(const QString& file);
  void reportOpened(DocumentTab& tab, const QString& file, const TakenFrames& frames, const QStringList& remarks);
  void verify();
  void verifyAgain();
  void reportVerified(const PathResult& result);
  void reportAllVerified();
  static QString failure() { return tr("This could not be done"); }
  // tab: null if no document is in view.
  void report(const DocumentTab* tab, const Error& error, const QString& title = failure());
  void report(const Error& error, const QString& title = failure()) { report(m_document, error, title); }
  // Reports the error of a plan that an obstacle hinders. The message offers to let a body touch the part that is
  // worked on, and to go to the position of the collision.
  void reportHindered(DocumentTab& tab, const Error& error, const QString& title, const PlanRequest& request);
  void reportUnprepared();
  void followDocument();
  void showPath();
  void update();
  void offerActions();

  WindowContext m_parts;
  CellCollisions& m_collisions;
  CellTargets& m_targets;
  CellRobots& m_robots;
  std::function<BodyPointer()> m_selected;
  DocumentTab* m_document = nullptr;
  PlanTree* m_tree;
  QLabel* m_detail;
  std::shared_ptr<PathLayer> m_layer;
  std::shared_ptr<const CheckedPath> m_drawn;            // The path in m_layer; null: none
  std::map<const DocumentTab*, PlanTree::Entry> m_rows;  // Selected row when the document was last in view
  PathChecks m_checks;
  std::optional<JointValues> m_shownJoints;
  std::optional<OperationValues> m_planned;              // Values last chosen in the dialog
  std::map<const DocumentTab*, WantedProcess> m_wanted;  // Settings of the jobs, at most one per document
  std::uint64_t m_remakes = 0;                           // Number of jobs begun by remakeProcess()
  QAction m_store, m_storeTarget, m_storeFrame, m_workIn, m_go, m_plan, m_again, m_insert, m_here, m_up, m_down,
      m_straight, m_verify, m_verifyAll, m_export, m_import, m_declareFrame, m_semantics, m_pairs, m_rename, m_remove,
      m_optimise, m_choose;
  QMenu* m_menu;  // Owned by the window
};

}  // namespace handwheel
