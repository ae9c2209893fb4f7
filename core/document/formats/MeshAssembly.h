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

// Builds a mesh from the points and polygons that a file reader delivers. It triangulates polygons, checks indices and
// unreadable points, keeps the list of damage, and decides when to stop. Every function that returns bool returns false
// if reading must end, either because it was cancelled or because damage was found and the file is not to be opened in
// part. finish() returns the reason.
class MeshAssembly {
 public:
  // firstIndex: the file's index of the first vertex; for messages only.
  MeshAssembly(const ReadOptions& options, Progress progress, std::uint64_t bytes, int firstIndex = 0);

  MeshAssembly(const MeshAssembly&) = delete;
  MeshAssembly& operator=(const MeshAssembly&) = delete;

  // Sets the number of bytes, if it is known only later.
  void expect(std::uint64_t bytes) { m_bytes = bytes; }

  TriangleSoup& soup() { return m_file.soup; }
  std::size_t pointCount() const { return m_file.soup.points.size(); }

  // Must be called often with the position reached: reports progress and checks for cancellation at intervals.
  bool advance(std::uint64_t byte) { return byte < m_nextLook || look(byte); }

  // Must be called in loops that do not advance: checks for cancellation at intervals.
  bool step() { return ++m_steps % kIterationsPerPoll != 0 || !cancelled(); }

  // Reports damage that loses something. Returns true if it was listed, and reading continues without that part.
  bool tolerate(Error error);
  // Reports damage that loses nothing. Listed in either mode.
  void mend(Error error);
  // Reports data after everything that was declared; `end` is the end of the declared data.
  void noteExcess(std::uint64_t end, InputPosition position);
  // Reports that the file cannot be opened, not even in part.
  bool fail(Error error);
  // Records a lost attribute. name: its name in the file; used for attributes without a name of ours.
  void lose(LostAttribute attribute, std::string_view name = {});

  // Adds a vertex that cannot be used. It keeps its index, so that later ones keep theirs; faces that use it are
  // dropped.
  bool addPoint(const Vec3& point);
  bool addUnreadablePoint(Error why);
  // Declares all points as added. From now on an index without a vertex is an error; before, the vertex may still come.
  void allPointsAdded() { m_allPointsAdded = true; }

  // Adds a polygon. Corners count from 0; negative ones are out of range. position: for errors.
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
