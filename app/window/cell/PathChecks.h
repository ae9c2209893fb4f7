// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/PathBasis.h"
#include "tools/cell/PathCheck.h"
#include "window/cell/CellCollisions.h"

#include <QDateTime>
#include <QStringList>
#include <deque>
#include <map>
#include <optional>

namespace handwheel {

// The result of the last verification of a path.
struct PathResult {
  PathBasis basis;
  std::shared_ptr<const CheckedPath> checked;  // null: it could not be verified
  QString problem = {};                        // then why
  QStringList collisions = {};                 // the first of them
  bool hasShapeless = false;                   // links without meshes were left out
  QDateTime at = {};
};

// What is known of the paths of the open cells. A path is verified on a worker, one at a time; its result is kept until
// it is verified again, also while another path or document is shown, and holds as long as nothing changes that it
// depends on. Window thread.
class PathChecks : public QObject {
  Q_OBJECT

 public:
  // What is known of a path now.
  struct State {
    const PathResult* last = nullptr;  // null: it was not verified since the document was opened
    BasisChange change = BasisChange::Nothing;
    bool isUnderWay = false;
  };
  enum class Wish { Known, Again };  // Again: even if it is known, and verified() follows

  PathChecks(const WindowContext& parts, CellCollisions& collisions, QObject* parent);
  ~PathChecks() override;

  void setDocument(DocumentTab* document);
  void forget(const DocumentTab* document) { m_results.erase(document); }

  // Begins to verify a path of the robot that is planned for, unless its result is known. What is under way for another
  // path or another state of it ends. The cell must be prepared.
  void verify(const RobotPath& path, Wish wish = Wish::Known);
  // All paths of that robot whose results are not known, one after the other.
  void verifyAll();
  State stateOf(const RobotPath& path) const;
  // What holds for the path as it and the cell are now; null: nothing.
  std::shared_ptr<const CheckedPath> of(const RobotPath& path) const;

 signals:
  void changed();
  void verified(const handwheel::PathResult& result);

 private:
  struct Run {
    PathBasis basis;
    bool isAsked = false;
    std::uint64_t number = 0;
  };

  std::shared_ptr<const RobotCellSnapshot> content() const;
  const PathResult* resultOf(const RobotPath& path, const RobotCellSnapshot& now) const;
  bool isRunning(const RobotPath& path, const RobotCellSnapshot& now) const;
  void goOn();
  void take(std::uint64_t run, const CellScene& scene, const Result<CheckedPath>& found);

  WindowContext m_parts;
  CellCollisions& m_collisions;
  DocumentTab* m_document = nullptr;
  std::map<const DocumentTab*, std::map<std::string, PathResult>> m_results;  // by the name of the path
  std::optional<Run> m_run;
  std::uint64_t m_runs = 0;           // that were begun
  std::deque<std::string> m_waiting;  // names of paths that are to be verified, too
};

}  // namespace handwheel
