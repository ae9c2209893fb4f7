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

// The reasons why defects remain: by kind, and also by row if a row has a reason of its own.
struct DefectReasons {
  std::map<DefectKind, QString> ofKind;
  std::map<std::pair<DefectKind, int>, QString> ofRow;
};

// The findings of the repair or fix that made the present mesh.
struct RepairFindings {
  std::map<DefectKind, std::size_t> before;
  LoopCounts loopOutcomes;
  QStringList doneBesides;
  QStringList patchWarnings;
  QString removalWarning;
  DefectReasons reasons;
  std::set<DefectKind> hopeless;
};

// The defects of a mesh document as the window shows them. Beyond the data of the document it knows which loops count
// as holes, the names of loops, the self-intersections (found later, by a job), and the reasons why a hole could not be
// filled. It follows changes of the document, and is used on the window thread.
class DefectList : public QObject {
  Q_OBJECT

 public:
  explicit DefectList(MeshDocument& document, QObject* parent = nullptr);

  const MeshDocument& document() const { return m_document; }
  const BoundaryLoop& loop(int id) const { return m_document.defects().loops[static_cast<std::size_t>(id)]; }
  int loopCount() const { return static_cast<int>(m_document.defects().loops.size()); }

  // Return loop ids. A loop that the user keeps open, or that is the outer edge of a sheet, is no hole.
  const std::vector<int>& holes() const { return m_holes; }
  const std::vector<int>& keptOpen() const { return m_keptOpen; }
  std::size_t sheetCount() const;  // number of open sheets, whose outer boundaries are in keptOpen()
  // Returns indices into defects().components.
  const std::vector<std::size_t>& debris() const { return m_debris; }
  // Excludes pieces with one of these corners from the debris, however small. Used for pieces that a fix cut from a
  // larger body.
  void keepPieces(const std::set<PointKey>& corners);

  // Returns the self-intersections after rounding to the number type of the document's file. They are absent until they
  // were computed for the present mesh.
  const std::optional<FacePairs>& selfIntersections() const { return m_selfIntersections; }
  void setSelfIntersections(std::uint64_t revision, FacePairs pairs);

  // Returns the number of defects of this kind; for self-intersections 0 while unknown.
  std::size_t count(DefectKind kind) const;
  // Returns the number of defects by kind. Self-intersections are missing while they are unknown.
  std::map<DefectKind, std::size_t> counts() const;
  // Sets the counts before the fix that made the present mesh, and the outcomes of the loops. They are kept until the
  // mesh changes.
  void setBefore(std::map<DefectKind, std::size_t> counts, LoopCounts loops);
  const LoopCounts& loopOutcomes() const { return m_findings.loopOutcomes; }
  // Returns a phrase for each further change of the last repair. They are kept until the mesh changes.
  const QStringList& doneBesides() const { return m_findings.doneBesides; }
  // Returns sentences about patches of the last repair that a person should look at. They are kept until the mesh
  // changes.
  const QStringList& patchWarnings() const { return m_findings.patchWarnings; }
  // Returns the sentence about material that the last repair removed from the outside; empty if there is none. It is
  // kept until the mesh changes.
  const QString& removalWarning() const { return m_findings.removalWarning; }
  // Returns the number of defects of this kind before the fix that made the present mesh. Returns nothing if it is
  // unknown, or the same as now.
  std::optional<std::size_t> countBefore(DefectKind kind) const;
  // Returns the state of the present mesh, with its self-intersections once they are computed.
  MeshState state() const;
  // Returns true if a repair would change nothing. Self-intersections count once they are known, until a repair has
  // found that it cannot resolve them.
  bool isClean() const;

  // Returns the number of a loop, assigned when it first appears, from 1. Holes and outer edges are counted separately.
  // The number does not change while other holes are filled. An outer edge that becomes a hole gets a number among the
  // holes.
  int loopNumber(int id) const;
  // Returns the name of a loop: "Hole 3".
  QString loopName(int id) const;
  // Returns the title of a loop: "Hole 3 — 42 edges, 31.2 mm"
  QString loopTitle(int id) const;
  QString loopLength(int id) const;  // "31.2 mm"
  QString loopDetail(int id) const;
  // Returns a text like "Area 12 mm². 0.3 mm from the best-fitting plane (RMS). 2 islands inside: …".
  QString loopMeasures(int id) const;

  FillFailure failure(int id) const;
  void setFailure(int id, FillFailure failure);
  // Returns the reason why a defect other than a hole remains after a repair or fix, as the end of a sentence. It is
  // the reason of the row, or else that of the kind. It is kept until the mesh changes.
  QString reason(DefectKind kind, int row) const;
  // Returns true if a fix of all defects of this kind was tried on the present mesh and changed nothing; see reason().
  bool isHopeless(DefectKind kind) const { return m_findings.hopeless.contains(kind); }
  void setHopeless(DefectKind kind);
  // Return and set everything that is kept until the mesh changes, so that undo and redo can restore it together with
  // the mesh.
  const RepairFindings& findings() const { return m_findings; }
  void setFindings(RepairFindings findings);
  // Sets the reason of a row, or with -1 that of all rows of the kind that have none of their own.
  void setReason(DefectKind kind, int row, const QString& reason);
  // Sets the failures by loop key; keys of removed loops are allowed.
  void setFailures(const std::map<Vertex, FillFailure>& failures);

  // Returns a key that identifies a loop across edits: the vertex at which it starts. loopWithKey() returns -1 if the
  // loop is gone.
  Vertex keyOf(int id) const;
  int loopWithKey(Vertex key) const;

 signals:
  void changed();
  // Emitted when the reasons of this kind have changed, but not the rows.
  void reasonsChanged(DefectKind kind);

 private:
  void documentChanged();
  void sortLoops();
  void nameLoops();

  MeshDocument& m_document;
  std::vector<int> m_holes;
  std::vector<int> m_keptOpen;
  std::vector<std::size_t> m_debris;
  std::set<PointKey> m_keptPieces;  // corners of kept pieces; by position, so that undo and redo find them again
  std::optional<FacePairs> m_selfIntersections;
  // The self-intersections of the same mesh in the former number type of its file. They are compared with the new ones
  // once these are computed.
  std::optional<FacePairs> m_intersectionsBeforeRounding;
  std::vector<Vertex> m_keys;                        // keys of the loops, by loop id
  std::map<std::pair<bool, Vertex>, int> m_numbers;  // numbers by (is an outer edge, key); from 1, never reused
  LoopNumbers m_named;
  std::map<Vertex, FillFailure> m_failures;
  RepairFindings m_findings;
};

}  // namespace handwheel
