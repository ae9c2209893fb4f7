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
  std::optional<PathFindings> found;           // Findings; nothing: the path could not be verified
  QString problem = {};                        // The reason why the path could not be verified
  std::shared_ptr<const CheckedPath> checked;  // Null: not verified in this session
  QDateTime at = {};
  // For a result that was read from the file: the input that was changed between its verification and the opening of
  // the document.
  BasisChange changedBefore = BasisChange::Nothing;
  BasisDigests digests = {};  // Digests of the basis
};

// The verification results of the paths of the open cells. A worker verifies paths, one at a time. Their last results
// are kept while other paths or documents are shown. A result is valid while all its inputs are unchanged, so undo
// makes it valid again. A summary of the valid result is stored with the cell, with digests of its inputs. The
// functions must be called on the window thread.
class PathChecks : public QObject {
  Q_OBJECT

 public:
  // The present verification state of a path.
  struct State {
    const PathResult* last = nullptr;  // The valid result, or else the last one; null: never verified
    BasisChange change = BasisChange::Nothing;
    bool isUnderWay = false;
  };
  // The kind of a request. Known: a path with a known result is not verified. Again: the path is verified even if its
  // result is known, and verified() is emitted. OfAll: like Known, for a path of verifyAll().
  enum class Request { Known, Again, OfAll };

  PathChecks(const WindowContext& parts, CellCollisions& collisions, QObject* parent);
  ~PathChecks() override;

  void setDocument(DocumentTab* document);
  void forget(const DocumentTab* document) {
    m_results.erase(document);
    m_recalled.erase(document);
    m_elsewhere.erase(document);
  }

  // Begins to verify a path, unless its result is known. A running verification of another path, or of another state of
  // this one, ends; it is repeated later if it belongs to verifyAll(). Does nothing if the cell is not prepared for the
  // robot of the path.
  void verify(const RobotPath& path, Request request = Request::Known);
  // Verifies all paths of all robots whose results are not known, one after the other. allVerified() is emitted
  // afterwards.
  void verifyAll();
  // Stores the results of a path under its new name. Must be called after the path was renamed.
  void renamed(const std::string& from, const std::string& to);
  State stateOf(const RobotPath& path) const;
  // Returns the result that is valid for the present path and cell; null if there is none.
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
  // The verifications of a document that is not in view. A running one goes on, if it was asked for; the others
  // continue when the document is shown again.
  struct Elsewhere {
    std::optional<Run> run;
    std::optional<PathResult> verified;  // the result of a run that ended meanwhile, to be reported
    std::deque<std::string> waiting;
    bool isAll = false;
  };
  // The result of a run, or its error.
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
  bool holds(const PathResult& result) const;  // returns true if the result is valid for the present cell
  void recall();
  void goOn();
  void fail(DocumentTab* document, std::uint64_t run);
  void take(DocumentTab* document, std::uint64_t run, const Outcome& outcome);
  PathResult added(DocumentTab* document, const Run& done, const Outcome& outcome);
  static void store(Document& document, const PathResult& result, bool isAsked);
  // Returns the run of this number, in view or elsewhere; null: it has been given up.
  std::optional<Run>* runOf(const DocumentTab* document, std::uint64_t number);
  void storeThoseThatHold();

  WindowContext m_parts;
  CellCollisions& m_collisions;
  DocumentTab* m_document = nullptr;
  QMetaObject::Connection m_changes;                               // Changes of the document
  using Results = std::map<std::string, std::vector<PathResult>>;  // Results by the name of the path, the latest last
  std::map<const DocumentTab*, Results> m_results;
  std::set<const DocumentTab*> m_recalled;  // Documents whose stored results have all been recalled
  std::optional<Run> m_run;
  std::uint64_t m_runs = 0;           // Number of runs begun
  std::deque<std::string> m_waiting;  // Names of the paths that are to be verified next
  bool m_isAllAsked = false;          // True from verifyAll() until all paths are verified
  std::map<const DocumentTab*, Elsewhere> m_elsewhere;
  std::shared_ptr<const PathDigests> m_digests;  // The last digests of the document
};

}  // namespace handwheel
