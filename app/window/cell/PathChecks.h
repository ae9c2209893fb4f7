// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/path/PathBasis.h"
#include "document/cell/path/PathDigests.h"
#include "tools/cell/path/PathCheck.h"
#include "window/cell/CellCollisions.h"

#include <QDateTime>
#include <QStringList>
#include <deque>
#include <map>
#include <optional>
#include <set>

namespace handwheel {

// The result of a verification of a path.
struct PathResult {
  PathBasis basis;
  std::optional<PathFindings> found;           // none: it could not be verified
  QString problem = {};                        // then why
  std::shared_ptr<const CheckedPath> checked;  // null: not in this session
  QDateTime at = {};
  BasisChange changedBefore = BasisChange::Nothing;  // of one that was stored: since then, before it was opened
  BasisDigests digests = {};                         // of the basis
};

// What is known of the paths of the open cells. A path is verified on a worker, one at a time. Its last results are
// kept, also while another path or document is shown. One holds while all that it depends on is as it was, so undo
// brings it back. The one that holds is stored with the cell in brief, with digests of what it depends on. Window
// thread.
class PathChecks : public QObject {
  Q_OBJECT

 public:
  // What is known of a path now.
  struct State {
    const PathResult* last = nullptr;  // that holds, else the last one; null: it was never verified
    BasisChange change = BasisChange::Nothing;
    bool isUnderWay = false;
  };
  // Again: even if it is known, and verified() follows. OfAll: one of all that a person asked for.
  enum class Request { Known, Again, OfAll };

  PathChecks(const WindowContext& parts, CellCollisions& collisions, QObject* parent);
  ~PathChecks() override;

  void setDocument(DocumentTab* document);
  void forget(const DocumentTab* document) {
    m_results.erase(document);
    m_recalled.erase(document);
    m_interrupted.erase(document);
  }

  // Begins to verify a path, unless its result is known. What is under way for another path or another state of it
  // ends. Nothing happens where the cell is not prepared for its robot.
  void verify(const RobotPath& path, Request request = Request::Known);
  // All paths of all robots whose results are not known, one after the other; allVerified() follows.
  void verifyAll();
  // To be called when a path got another name: what is stored of it goes along.
  void renamed(const std::string& from, const std::string& to);
  State stateOf(const RobotPath& path) const;
  // What holds for the path as it and the cell are now; null: nothing.
  std::shared_ptr<const CheckedPath> of(const RobotPath& path) const;

 signals:
  void changed();
  void verified(const handwheel::PathResult& result);
  void allVerified();

 private:
  struct Run {
    PathBasis basis;
    bool isAsked = false;
    bool isOfAll = false;
    std::uint64_t number = 0;
  };
  // What was left to be verified when another document came into view: it goes on when this one is shown again.
  struct Interrupted {
    std::optional<std::string> asked;  // by its name
    std::deque<std::string> waiting;
    bool isAll = false;
  };
  // What a run found, or why nothing.
  struct Outcome {
    Result<CheckedPath> checked;
    std::shared_ptr<const CellScene> scene;
    std::shared_ptr<const PathDigests> digests;
  };

  std::shared_ptr<const RobotCellSnapshot> content() const;
  std::shared_ptr<const CellScene> sceneFor(const RobotPath& path, const RobotCellSnapshot& now) const;
  static BasisChange changeOf(const PathResult& result, const RobotCellSnapshot& now, const RobotPath& path);
  const PathResult* resultOf(const RobotPath& path, const RobotCellSnapshot& now) const;
  bool isRunning(const RobotPath& path, const RobotCellSnapshot& now) const;
  void recall();
  void goOn();
  void take(std::uint64_t run, const Outcome& outcome);
  void store(const PathResult& result, bool isAsked);
  void storeThoseThatHold();

  WindowContext m_parts;
  CellCollisions& m_collisions;
  DocumentTab* m_document = nullptr;
  QMetaObject::Connection m_changes;                               // of the document
  using Results = std::map<std::string, std::vector<PathResult>>;  // by the name of the path, the last one behind
  std::map<const DocumentTab*, Results> m_results;
  std::set<const DocumentTab*> m_recalled;  // of which nothing stored is left to be recalled
  std::optional<Run> m_run;
  std::uint64_t m_runs = 0;            // that were begun
  std::deque<std::string> m_waiting;   // names of paths that are to be verified, too
  bool m_isAllAsked = false;           // verifyAll() was called, and they are not done
  std::optional<std::string> m_asked;  // the path that a person asked for before another document came into view
  std::map<const DocumentTab*, Interrupted> m_interrupted;
  std::shared_ptr<const PathDigests> m_digests;  // the last that were made of the document
};

}  // namespace handwheel
