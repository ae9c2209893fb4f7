// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/mesh/MeshDocument.h"
#include "mesh/boundary/LoopNumbers.h"
#include "mesh/repair/OutcomeCounts.h"
#include "mesh/structure/PositionKey.h"
#include "theme/DefectKind.h"

#include <QObject>
#include <QStringList>
#include <map>
#include <optional>
#include <set>

namespace handwheel {

using FacePairs = std::vector<std::pair<Face, Face>>;

inline bool isLoopKind(DefectKind kind) {
  return kind == DefectKind::Hole || kind == DefectKind::KeptOpen;
}

// One defect in the list, or all of a kind.
struct DefectRow {
  DefectKind kind;
  int row;  // -1: all
};

// Why defects remain: by kind, and by row where that is known.
struct DefectReasons {
  std::map<DefectKind, QString> ofKind;
  std::map<std::pair<DefectKind, int>, QString> ofRow;
};

// What the repair or fix that made the present mesh has found out about it.
struct RepairFindings {
  std::map<DefectKind, std::size_t> before;
  LoopCounts loopOutcomes;
  QStringList doneBesides;
  QStringList patchWarnings;
  QString removalWarning;
  DefectReasons reasons;
  std::set<DefectKind> hopeless;
};

// The defects of a mesh document as the window shows them. Adds to the document which loops count as holes, the loop
// names, the self-intersections (found later, by a job) and why a hole could not be filled. Follows changes of the
// document; window thread.
class DefectList : public QObject {
  Q_OBJECT

 public:
  explicit DefectList(MeshDocument& document, QObject* parent = nullptr);

  const MeshDocument& document() const { return m_document; }
  const BoundaryLoop& loop(int id) const { return m_document.defects().loops[static_cast<std::size_t>(id)]; }
  int loopCount() const { return static_cast<int>(m_document.defects().loops.size()); }

  // Loop ids. A loop that the user keeps open, or that is the outer edge of a sheet, is no hole.
  const std::vector<int>& holes() const { return m_holes; }
  const std::vector<int>& keptOpen() const { return m_keptOpen; }
  // Indices into defects().components.
  std::size_t sheetCount() const;  // open sheets, which keptOpen() has with their outer boundaries
  const std::vector<std::size_t>& debris() const { return m_debris; }
  // Pieces with one of these corners are no debris, however small: a fix cut them from a larger body.
  void keepPieces(const std::set<PointKey>& corners);

  // As the document's file holds the mesh, which may have fewer digits. Absent until computed for the present mesh.
  const std::optional<FacePairs>& selfIntersections() const { return m_selfIntersections; }
  void setSelfIntersections(std::uint64_t revision, FacePairs pairs);

  // The number of defects of this kind; for self-intersections 0 while unknown.
  std::size_t count(DefectKind kind) const;
  // The numbers of all kinds of defects; without self-intersections while these are unknown.
  std::map<DefectKind, std::size_t> counts() const;
  // Sets what there was before the fix that made the present mesh, and what it did with the loops. Kept until the mesh
  // changes.
  void setBefore(std::map<DefectKind, std::size_t> counts, LoopCounts loops);
  const LoopCounts& loopOutcomes() const { return m_findings.loopOutcomes; }
  // What else the last repair did, a phrase each. Kept until the mesh changes.
  const QStringList& doneBesides() const { return m_findings.doneBesides; }
  // Sentences about patches of the last repair that a person should look at. Kept until the mesh changes.
  const QStringList& patchWarnings() const { return m_findings.patchWarnings; }
  // The sentence about what the last repair took away from the outside; empty where nothing. Kept until the mesh
  // changes.
  const QString& removalWarning() const { return m_findings.removalWarning; }
  // None where nothing is known to compare with, or the number is the same.
  std::optional<std::size_t> countBefore(DefectKind kind) const;
  // The state of the present mesh, with its self-intersections once they are computed.
  MeshState state() const;
  // Whether there is nothing that a repair would change; self-intersections count once they are known, until one has
  // found that it cannot resolve them.
  bool isClean() const;

  // The number of a loop, assigned when it first appears, from 1; holes and outer edges are counted separately. It does
  // not change while other holes are filled; an outer edge that becomes a hole gets a number among these.
  int loopNumber(int id) const;
  // The name of a loop: "Hole 3"
  QString loopName(int id) const;
  // "Hole 3 — 42 edges, 31.2 mm"
  QString loopTitle(int id) const;
  QString loopLength(int id) const;  // "31.2 mm"
  QString loopDetail(int id) const;
  // "Area 12 mm². 0.3 mm off the plane that fits best (RMS). 2 islands in it."
  QString loopMeasures(int id) const;

  FillFailure failure(int id) const;
  void setFailure(int id, FillFailure failure);
  // Why a defect other than a hole remains after a repair or fix, as the end of a sentence: its own reason, else that
  // of its kind. Kept until the mesh changes.
  QString reason(DefectKind kind, int row) const;
  // A fix of all of this kind was tried on the present mesh and changed nothing; reason() says why.
  bool isHopeless(DefectKind kind) const { return m_findings.hopeless.contains(kind); }
  void setHopeless(DefectKind kind);
  // All that is kept until the mesh changes: for the state of the history that undo and redo come back to.
  const RepairFindings& findings() const { return m_findings; }
  void setFindings(RepairFindings findings);
  // Of a row, or -1: of those of the kind without their own.
  void setReason(DefectKind kind, int row, const QString& reason);
  // Sets the failures by loop key; keys of removed loops are allowed.
  void setFailures(const std::map<Vertex, FillFailure>& failures);

  // A key that identifies a loop across edits: the vertex at which it starts. loopWithKey() returns -1 if the loop is
  // gone.
  Vertex keyOf(int id) const;
  int loopWithKey(Vertex key) const;

 signals:
  void changed();
  // Of these reasons only; the rows are the same.
  void reasonsChanged(DefectKind kind);

 private:
  void documentChanged();
  void sortLoops();
  void nameLoops();

  MeshDocument& m_document;
  std::vector<int> m_holes;
  std::vector<int> m_keptOpen;
  std::vector<std::size_t> m_debris;
  std::set<PointKey> m_keptPieces;  // corners; by position, so that undo and redo find them again
  std::optional<FacePairs> m_selfIntersections;
  std::optional<FacePairs> m_intersectionsBeforeRounding;  // as the former file held the same mesh
  std::vector<Vertex> m_keys;                              // by loop id
  std::map<std::pair<bool, Vertex>, int> m_numbers;        // by being an outer edge, and key; from 1, never reused
  LoopNumbers m_named;
  std::map<Vertex, FillFailure> m_failures;
  RepairFindings m_findings;
};

}  // namespace handwheel
