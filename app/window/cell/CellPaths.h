// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/MessageBar.h"
#include "tools/cell/PathCheck.h"
#include "tools/cell/PlanOperation.h"
#include "tools/cell/ProcessOperation.h"
#include "window/cell/CellCollisions.h"
#include "window/cell/PlanTree.h"

#include <QAction>
#include <QMenu>
#include <QPointer>

namespace handwheel {

class CellRobots;
struct OptimisedPath;
class PathLayer;
class Post;
class RobotCellDocument;
struct WrittenProgram;

// The list of what is planned in a robot cell and its actions: stores configurations and targets, plans paths through
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
  QList<QAction*> all();
  QList<QAction*> buttons() { return {&m_store, &m_storeTarget, &m_plan, &m_verify, &m_export}; }  // those of the panel
  QMenu& menu() { return *m_menu; }
  // Plans a path along a curve on a part (processOperation()). surface: of the part; null: it is found.
  void planProcess(const OperationValues& values, std::shared_ptr<const PartSurface> surface);
  // Inserts the configuration of the document into the path of the selected row, or begins one with it.
  void addPlace();
  PlanTree* tree() const { return m_tree; }  // owned by the window
  void setVisible(bool isVisible);           // the line of the path in the view

  const NamedTarget* target() const;  // of the selected row; null: that is none
  // The present path, and what is known of it; null while nothing is.
  const RobotPath* path() const;
  std::shared_ptr<const CheckedPath> checked() const;
  std::shared_ptr<const CellScene> scene() const { return m_collisions.scene(); }
  const CellPlans& plans() const;

 signals:
  void rowChanged();   // another row is selected
  void pathChanged();  // the present path, or what is known of it
  void message(const handwheel::Message& message);

 private:
  // What was found for a path in a cell.
  struct Check {
    RobotPath path;
    std::shared_ptr<const CellScene> scene;
    double clearance = 0.0;
    Pose tool;
    std::shared_ptr<const CheckedPath> result;  // null: under way, or impossible
    QString problem = {};
    std::uint64_t run = 0;  // of m_runs; by which it was begun
  };

  RobotCellDocument& cell() const;
  void connectActions();
  void commit(const QString& text, CellPlans plans);
  void store();
  void storeTarget();
  void setTargetHere(const std::string& name);
  void goTo(const PlanTree::Entry& entry);
  void goToTarget(const std::string& name);
  void askForPath();
  void plan(const OperationValues& values);
  void planAgain();
  void optimise();
  void takeOptimised(const OptimisedPath& optimised);
  // again: what begins the same once more, for the cell as it is then.
  void startPlanning(std::vector<PathPlace> places, const RouteSettings& settings, const std::string& name,
                     const QString& text, std::function<void()> again);
  using Planning = std::function<Result<PlannedPath>(const CellScene& scene, const RobotCellSnapshot& cell, Progress)>;
  static Planning processPlanning(const OperationValues& values, std::shared_ptr<const PartSurface> surface,
                                  const std::optional<Pose>& chosenAt);
  void startPlanning(Planning planning, const std::string& name, const QString& text, std::function<void()> again);
  void takePlanned(RobotPath planned, const std::optional<RobotPath>& before, const QString& text);
  void reportChanged(const std::string& path, const std::function<void()>& again);
  void insertHere();
  void setPlaceHere();
  void movePlace(int by);
  void setStraight(bool isStraight);
  void removeCurrent();
  void rename(const PlanTree::Entry& entry, const QString& name);
  void readSemantics(const QString& file);
  void askForProgram();
  void exportAs(const QString& file, const Post& chosen);
  void exportProgram(const Post& post, const QString& file);
  void reportWritten(const WrittenProgram& written, const Post& post, const QString& file);
  void importProgram(const QString& file);
  void verify();
  void report(const Error& error);
  void reportUnprepared();
  void followDocument();
  void showPath();
  void update();
  void offerActions();
  QString remarkOf(const Check& check) const;
  bool isCurrent(const Check& check) const;

  WindowContext m_parts;
  CellCollisions& m_collisions;
  CellTargets& m_targets;
  CellRobots& m_robots;
  std::function<BodyPointer()> m_selected;
  DocumentTab* m_document = nullptr;
  PlanTree* m_tree;
  std::shared_ptr<PathLayer> m_layer;
  std::map<std::string, Check> m_checks;  // by the name of the path; their jobs belong to it
  std::uint64_t m_runs = 0;               // verifications that were begun
  QAction m_store, m_storeTarget, m_go, m_plan, m_again, m_insert, m_here, m_up, m_down, m_straight, m_verify, m_export,
      m_import, m_semantics, m_remove, m_optimise, m_choose;
  QMenu* m_menu;  // owned by the window
};

}  // namespace handwheel
