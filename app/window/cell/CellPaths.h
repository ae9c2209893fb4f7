// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/MessageBar.h"
#include "tools/cell/ProcessPathOperation.h"
#include "tools/cell/path/PathExport.h"
#include "tools/cell/path/PlanOperation.h"
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

// The list of the plans of a robot cell and its actions. Stores configurations, targets and frames, plans paths through
// them, edits their places, verifies and shows them. The path of the selected row, or the only one, is the present one,
// if it is of the robot that is planned for.
class CellPaths : public QObject {
  Q_OBJECT

 public:
  // selected: the body that is selected alone; null: none is.
  CellPaths(const WindowContext& parts, CellCollisions& collisions, CellTargets& targets, CellRobots& robots,
            std::function<BodyPointer()> selected, QObject* parent);
  ~CellPaths() override;

  void setDocument(DocumentTab* document);
  void forget(const DocumentTab* document);
  // The actions, by what they are for.
  QList<QAction*> ofConfigurations() { return {&m_store, &m_storeTarget, &m_storeFrame, &m_go, &m_workIn}; }
  QList<QAction*> ofPaths() {
    return {&m_plan, &m_again, &m_optimise, &m_insert, &m_here, &m_up, &m_down, &m_straight};
  }
  QList<QAction*> ofPrograms() { return {&m_export, &m_import, &m_declareFrame}; }
  QList<QAction*> ofVerification() { return {&m_verify, &m_verifyAll, &m_pairs, &m_semantics}; }
  QList<QAction*> ofRows() { return {&m_rename, &m_remove}; }
  QAction* choosing() { return &m_choose; }                                                        // the robot
  QList<QAction*> buttons() { return {&m_store, &m_storeTarget, &m_plan, &m_verify, &m_export}; }  // those of the panel
  QMenu& menu() { return *m_menu; }
  // Plans a path along a curve on a part (processPathOperation()). surface: of the part; null: it is found.
  void planProcess(const OperationValues& values, std::shared_ptr<const PartSurface> surface);
  // What is known of the path of the selected row, as fields to read, and the clearance that it keeps; empty: it is no
  // path.
  std::vector<Property> resultProperties() const;
  // How the path of the selected row is worked off along its curve; empty: it is no such path.
  std::vector<Property> processProperties() const;
  // Plans that path anew with one of these changed; false: the id is none of them.
  bool takeProcessEdit(const std::string& id, const PropertyValue& value, bool stillDragging);
  // Adds the configuration of the document to the path of the selected row, behind the selected place or at the end, or
  // begins one with it.
  void addPlace();
  PlanTree* tree() const { return m_tree; }    // owned by the window
  QLabel* detail() const { return m_detail; }  // what is known of the selected row in full; owned by the window
  void setVisible(bool isVisible);             // the line of the path in the view

  // What the view shows in place of where the robot stands, while a path is played; none: nothing. Configurations,
  // places, targets and frames are stored as they are seen.
  void setShownJoints(std::optional<JointValues> joints) { m_shownJoints = std::move(joints); }

  bool showsOtherJoints() const { return m_shownJoints.has_value(); }
  // As the view shows the robots of the cell.
  const JointValues& seenJoints(const RobotCellDocument& of) const;

  const NamedTarget* target() const;  // of the selected row; null: that is none
  const NamedFrame* frame() const;    // likewise
  // The present path, and what is known of it; null while nothing is.
  const RobotPath* path() const;
  std::shared_ptr<const CheckedPath> checked() const;
  std::shared_ptr<const CellScene> scene() const { return m_collisions.scene(); }
  const CellPlans& plans() const;

 signals:
  void rowChanged();                         // another row is selected
  void pathChanged();                        // the present path, or what is known of it
  void robotSent();                          // to a configuration, place or target, where it is to be seen
  void collisionChosen(std::size_t number);  // of the present path, by its number in stretchesOf()
  void message(const handwheel::Message& message);

 private:
  RobotCellDocument& cell() const;
  const JointValues& seenJoints() const { return seenJoints(cell()); }
  CellPlacement seenPlacement() const;
  void connectActions();
  static RobotCellDocument& cellIn(DocumentTab& tab);
  // Whether the cell is still as it was when the scene was made of it.
  static bool isUnchanged(DocumentTab& tab, const CellScene& scene, const RobotCellSnapshot& before);
  // False: there are too many, which was reported.
  bool commit(DocumentTab& tab, const QString& text, CellPlans plans);
  bool commit(const QString& text, CellPlans plans) { return commit(*m_document, text, std::move(plans)); }
  void select(const DocumentTab& tab, const PlanTree::Entry& entry);  // if it is in view
  void store();
  void storeTarget();
  void setTargetHere(const std::string& name);
  void setConfigurationHere(const std::string& name);
  void storeFrame();
  void setFrameHere(const std::string& name);
  void workIn(const std::string& name);  // or in none, if it is in this frame
  BodyPointer bodyForPlaces() const;     // that what is stored is on; null: none
  std::map<std::string, QString> frameRemarks() const;
  void goTo(const PlanTree::Entry& entry);
  void goToTarget(const std::string& name);
  void askForPath();
  void plan(const OperationValues& values);
  void planAgain();
  void optimise();
  void takeOptimised(DocumentTab& tab, const OptimisedPath& optimised);
  // again: what begins the same once more, for the cell as it is then.
  void startPlanning(std::vector<Waypoint> places, const RouteSettings& settings, const std::string& name,
                     const QString& text, std::function<void()> again);
  using Planning = std::function<Result<PlannedPath>(const CellScene& scene, const RobotCellSnapshot& cell, Progress)>;
  static Planning processPlanning(const OperationValues& values, std::shared_ptr<const PartSurface> surface,
                                  const std::optional<Pose>& chosenAt);
  // What is planned, and what follows.
  struct PlanRequest {
    std::string name;  // of the path
    QString text;      // of the step, with %1 for the name
    std::function<void()> again;
    std::function<void()> ended = {};  // called before the result is taken, or when there is none
    const void* owner = nullptr;       // of the job; null: the document
    std::string part = {};             // that a new path leads along; empty: none, or that of the path of this name
  };
  void startPlanning(Planning planning, PlanRequest request);
  // Calls what needs scene(): at once, or when the cell has been prepared. Not where another document is in view by
  // then.
  void whenPrepared(const std::function<void()>& then);
  // How a path is to be worked off that is being planned for it; the owner of that job.
  struct WantedProcess {
    std::string path;
    OperationValues values;
    std::uint64_t number = 0;  // of m_remakes
  };
  const WantedProcess* wanted(const std::string& path) const;  // of the document in view; null: none is
  void remakeProcess(const std::string& name, const OperationValues& values);
  void takePlanned(DocumentTab& tab, PlannedPath made, const std::optional<RobotPath>& before, const QString& text);
  void reportChanged(DocumentTab& tab, const std::string& path, const std::function<void()>& again);
  void insertHere();
  void insertAt(std::size_t behind);  // in the present path
  void setPlaceHere();
  void movePlace(int by);
  void setStraight(bool isStraight);
  void removeCurrent();
  void rename(const PlanTree::Entry& entry, const QString& name);
  // named: what may be given a better name at once.
  void reportStored(const DocumentTab& tab, const QString& title, const QString& detail,
                    std::optional<PlanTree::Entry> named = {});
  void showSelected();  // in the view
  void showDetail();
  void askForPairs();
  void readSemantics(const QString& file);
  void reportSemantics(const DocumentTab& tab, const RobotSemantics& read, const QString& file, const QString& robot);
  void requestProgram();
  void askForProgram(OutdatedPath outdated);
  // What is to be written, as it was when that was asked for.
  struct ProgramRequest {
    RobotPath path;
    OutdatedPath outdated;
  };
  bool choosePath(const std::string& name);
  void exportAs(const QString& file, const PostProcessor& ofType, const ProgramRequest& request);
  void exportProgram(const PostProcessor& post, const QString& file, const ProgramRequest& request);
  void reportRemoved(const QString& configuration, const std::vector<std::string>& paths);
  void reportNotWritten(const std::string& path);
  // tab: null where it was closed.
  void reportWritten(const DocumentTab* tab, const WrittenProgram& written, const PostProcessor& post,
                     const QString& file, const CheckedPath& checked);
  void importProgram(const QString& file);
  void reportOpened(DocumentTab& tab, const QString& file, const TakenFrames& frames, const QStringList& remarks);
  void verify();
  void verifyAgain();
  void reportVerified(const PathResult& result);
  void reportAllVerified();
  static QString failure() { return tr("This could not be done"); }
  // tab: null where none is in view.
  void report(const DocumentTab* tab, const Error& error, const QString& title = failure());
  void report(const Error& error, const QString& title = failure()) { report(m_document, error, title); }
  // The error of a plan that something hinders. The message offers to let a body touch the part that is worked on, and
  // to go to the place where it is met.
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
  std::shared_ptr<const CheckedPath> m_drawn;            // in that layer; null: nothing is
  std::map<const DocumentTab*, PlanTree::Entry> m_rows;  // that were selected when it was in view last
  PathChecks m_checks;
  std::optional<JointValues> m_shownJoints;
  std::optional<OperationValues> m_planned;              // what was chosen in the dialog last
  std::map<const DocumentTab*, WantedProcess> m_wanted;  // one at most of a document
  std::uint64_t m_remakes = 0;                           // that were begun
  QAction m_store, m_storeTarget, m_storeFrame, m_workIn, m_go, m_plan, m_again, m_insert, m_here, m_up, m_down,
      m_straight, m_verify, m_verifyAll, m_export, m_import, m_declareFrame, m_semantics, m_pairs, m_rename, m_remove,
      m_optimise, m_choose;
  QMenu* m_menu;  // owned by the window
};

}  // namespace handwheel
