// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/formats/MeshFormat.h"
#include "document/formats/PolygonTriangulation.h"

#include <cstdint>
#include <optional>
#include <set>
#include <span>

namespace handwheel {

// The assembly of a mesh from the points and polygons that a file reader delivers. It triangulates polygons, checks
// indices and unreadable points, and keeps the list of damage. Every function that returns bool returns false if
// reading must end, either because it was cancelled or because damage was found and partial reading was not requested.
// finish() then returns the reason.
class MeshAssembly {
 public:
  // Prepares an empty mesh. bytes: the size of the file, for progress. firstIndex: the file's index of the first
  // vertex; for messages only.
  MeshAssembly(const ReadOptions& options, Progress progress, std::uint64_t bytes, int firstIndex = 0);

  MeshAssembly(const MeshAssembly&) = delete;
  MeshAssembly& operator=(const MeshAssembly&) = delete;

  // Sets the size of the file, for progress, if it becomes known only later.
  void expect(std::uint64_t bytes) { m_bytes = bytes; }

  TriangleSoup& soup() { return m_file.soup; }
  std::size_t pointCount() const { return m_file.soup.points.size(); }

  // Reports progress and checks for cancellation at intervals. Must be called often, with the position reached.
  bool advance(std::uint64_t byte) { return byte < m_nextLook || look(byte); }

  // Checks for cancellation at intervals. Must be called in loops that do not call advance().
  bool step() { return ++m_steps % kIterationsPerPoll != 0 || !cancelled(); }

  // Records damage that loses part of the file. Returns true if reading continues without the damaged part.
  bool tolerate(Error error);
  // Records damage that loses no part of the file. It is listed even if partial reading was not requested.
  void mend(Error error);
  // Records data after the end of the declared data. end: the end of the declared data. position: the position of the
  // data after it.
  void noteExcess(std::uint64_t end, InputPosition position);
  // Records an error because of which the file cannot be opened, not even in part.
  bool fail(Error error);
  // Records a lost attribute. name: the name in the file, for LostAttribute::Other.
  void lose(LostAttribute attribute, std::string_view name = {});

  // Adds a vertex, or a vertex that cannot be read. An unreadable vertex also gets an index, so that later vertices
  // keep theirs; faces that use it are dropped.
  bool addPoint(const Vec3& point);
  bool addUnreadablePoint(Error why);
  // Declares that all points were added. An index without a vertex is an error from now on; before this call the vertex
  // may still be added later.
  void allPointsAdded() { m_allPointsAdded = true; }

  // Adds a polygon. corners: indices from 0; negative indices are out of range. position: its position in the file, for
  // errors.
  bool addPolygon(std::span<const std::int64_t> corners, InputPosition position);

  // Returns the mesh or the error. hasUnit: see MeshFile.
  Result<MeshFile> finish(NumberType numbers, bool hasUnit = false);

 private:
  struct Deferred {
    std::size_t first;
    std::size_t count;
    InputPosition position;
  };

  static constexpr std::uint64_t kIterationsPerPoll = 1 << 16;

  bool look(std::uint64_t byte);
  bool cancelled();
  bool cutPolygon(std::span<const std::int64_t> corners, InputPosition position);
  bool judgeCorners(std::span<const std::int64_t> corners, InputPosition position);
  bool resolveDeferred();
  bool dropUnreadablePoints();
  void list(Error error);

  MeshFile m_file;
  bool m_partial;
  Progress m_progress;
  std::uint64_t m_bytes;
  std::uint64_t m_nextLook = 0;
  std::uint64_t m_steps = 0;
  int m_firstIndex;
  bool m_allPointsAdded = false;
  std::size_t m_unreadablePoints = 0;
  std::optional<Error> m_failure;
  std::set<LostAttribute> m_lost;
  bool m_hasUnlistedLoss = false;  // for LostAttribute::Other
  PolygonTriangulation m_triangulation;
  std::vector<std::uint32_t> m_ring;  // buffer
  std::vector<std::int64_t> m_deferredCorners;
  std::vector<Deferred> m_deferred;
};

}  // namespace handwheel
