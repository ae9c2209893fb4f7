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

// What the readers put a file's content into. It cuts polygons, judges indices and unreadable points, keeps the list of
// damage, and says when to stop: every function that returns bool says false when reading must end, be it because
// somebody cancelled or because damage was met and the file is not to be opened in part. finish() knows why.
class MeshAssembly {
 public:
  // firstIndex: what the file calls the first vertex; for messages only.
  MeshAssembly(MeshFormat format, const ReadOptions& options, Progress progress, std::uint64_t bytes,
               int firstIndex = 0);

  MeshAssembly(const MeshAssembly&) = delete;
  MeshAssembly& operator=(const MeshAssembly&) = delete;

  // How many bytes there will be, where that is known only later.
  void expect(std::uint64_t bytes) { m_bytes = bytes; }

  TriangleSoup& soup() { return m_file.soup; }
  std::size_t pointCount() const { return m_file.soup.points.size(); }

  // To be called often with the place reached: reports progress and looks for cancellation now and then.
  bool advance(std::uint64_t byte) { return byte < m_nextLook || look(byte); }

  // To be called in loops that do not advance: looks for cancellation now and then.
  bool step() { return ++m_steps % kStepsPerLook != 0 || !cancelled(); }

  // Something is lost. True: note it and go on without.
  bool tolerate(Error error);
  // Something is not as it should be, but nothing is lost. Listed in either mode.
  void mend(Error error);
  // Data behind everything that was announced; `end` is where that ends.
  void noteExcess(std::uint64_t end, Place place);
  // The file cannot be opened, not even in part.
  bool fail(Error error);
  void lose(LostAttribute attribute) { m_lost.insert(attribute); }

  // The vertex keeps its number, so that later ones keep theirs; faces that use it are dropped.
  bool addPoint(const Vec3& point);
  bool addUnreadablePoint(Error why);
  // From now on an index that no vertex has is an error; before, the vertex may still come.
  void allPointsAdded() { m_allPointsAdded = true; }

  // Corners from 0; negative ones are out of range. Place: for errors.
  bool addPolygon(std::span<const std::int64_t> corners, Place place);

  Result<MeshFile> finish(NumberType numbers);

 private:
  struct Deferred {
    std::size_t first;
    std::size_t count;
    Place place;
  };

  static constexpr std::uint64_t kStepsPerLook = 1 << 16;

  bool look(std::uint64_t byte);
  bool cancelled();
  bool cutPolygon(std::span<const std::int64_t> corners, Place place);
  bool judgeCorners(std::span<const std::int64_t> corners, Place place);
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
  PolygonTriangulation m_triangulation;
  std::vector<std::uint32_t> m_ring;  // buffer
  std::vector<std::int64_t> m_deferredCorners;
  std::vector<Deferred> m_deferred;
};

}  // namespace handwheel
