// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshAssembly.h"

#include "document/formats/MeshFileErrors.h"
#include "mesh/structure/MeshErrors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr std::size_t kListedDamage = 1000;
constexpr std::uint64_t kBytesPerLook = 256 * 1024;  // a few milliseconds of text
constexpr std::size_t kMostElements = kNone - 1;     // vertices and triangles are numbered in 32 bits

bool isReadable(const Vec3& p) {
  return !std::isnan(p.x());
}

}  // namespace

MeshAssembly::MeshAssembly(const ReadOptions& options, Progress progress, std::uint64_t bytes, int firstIndex)
    : m_partial(options.partial),
      m_progress(progress),
      m_bytes(bytes),
      m_firstIndex(firstIndex),
      m_triangulation([this] { return !cancelled(); }) {}

bool MeshAssembly::look(std::uint64_t byte) {
  m_nextLook = byte + kBytesPerLook;
  m_progress.set(std::min(1.0, static_cast<double>(byte) / static_cast<double>(std::max<std::uint64_t>(m_bytes, 1))));
  return !cancelled();
}

bool MeshAssembly::cancelled() {
  if (!m_progress.cancelled()) return false;
  m_failure = Error{ErrorCode::Cancelled, {}, {}, {}};
  return true;
}

bool MeshAssembly::tolerate(Error error) {
  if (!m_partial) return fail(std::move(error));
  list(std::move(error));
  return true;
}

void MeshAssembly::mend(Error error) {
  list(std::move(error));
}

void MeshAssembly::noteExcess(std::uint64_t end, InputPosition position) {
  mend({ErrorCode::CountMismatch, {"bytes", std::to_string(end), std::to_string(m_bytes)}, position, {}});
}

bool MeshAssembly::fail(Error error) {
  if (!m_failure) m_failure = std::move(error);
  return false;
}

void MeshAssembly::list(Error error) {
  if (m_file.damage.size() < kListedDamage)
    m_file.damage.push_back(std::move(error));
  else
    ++m_file.unlistedDamage;
}

bool MeshAssembly::addPoint(const Vec3& point) {
  auto& points = m_file.soup.points;
  if (points.size() >= kMostElements)
    return fail({ErrorCode::FileTooLarge, {"vertices", "", std::to_string(kMostElements)}, {}, {}});
  points.push_back(point);
  return true;
}

bool MeshAssembly::addUnreadablePoint(Error why) {
  if (!tolerate(std::move(why))) return false;
  ++m_unreadablePoints;
  return addPoint(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
}

bool MeshAssembly::addPolygon(std::span<const std::int64_t> corners, InputPosition position) {
  if (corners.size() < 3)
    return tolerate({MeshFileError::PolygonTooSmall, {std::to_string(corners.size())}, position, {}});
  const auto known = static_cast<std::int64_t>(pointCount());
  bool forward = false;
  for (std::int64_t c : corners) forward |= c >= known;
  if (!forward || m_allPointsAdded) return judgeCorners(corners, position);
  m_deferred.push_back({m_deferredCorners.size(), corners.size(), position});
  m_deferredCorners.insert(m_deferredCorners.end(), corners.begin(), corners.end());
  return true;
}

bool MeshAssembly::judgeCorners(std::span<const std::int64_t> corners, InputPosition position) {
  const auto& points = m_file.soup.points;
  for (std::int64_t c : corners) {
    const bool inRange = c >= 0 && c < static_cast<std::int64_t>(points.size());
    if (inRange && (m_unreadablePoints == 0 || isReadable(points[static_cast<std::size_t>(c)]))) continue;
    const std::string written = std::to_string(c + m_firstIndex);
    if (inRange) return tolerate({MeshFileError::VertexUnreadable, {written}, position, {}});
    return tolerate({MeshFileError::IndexOutOfRange, {written, std::to_string(points.size())}, position, {}});
  }
  return cutPolygon(corners, position);
}

bool MeshAssembly::cutPolygon(std::span<const std::int64_t> corners, InputPosition position) {
  auto& triangles = m_file.soup.triangles;
  if (corners.size() > kMostElements - triangles.size())
    return fail({ErrorCode::FileTooLarge, {"triangles", "", std::to_string(kMostElements)}, position, {}});
  m_ring.clear();
  for (std::int64_t c : corners) m_ring.push_back(static_cast<std::uint32_t>(c));
  if (m_ring.size() == 3) {
    triangles.push_back({m_ring[0], m_ring[1], m_ring[2]});
    return true;
  }
  switch (m_triangulation.cut(m_file.soup.points, m_ring, triangles)) {
    case PolygonTriangulation::Outcome::Done:
      return true;
    case PolygonTriangulation::Outcome::TooComplex:
      mend({MeshFileError::PolygonTooComplex, {std::to_string(corners.size())}, position, {}});
      return true;
    case PolygonTriangulation::Outcome::Stopped:
      break;
  }
  return false;
}

bool MeshAssembly::resolveDeferred() {
  for (const Deferred& polygon : m_deferred) {
    const auto corners = std::span(m_deferredCorners).subspan(polygon.first, polygon.count);
    if (!step() || !judgeCorners(corners, polygon.position)) return false;
  }
  return true;
}

bool MeshAssembly::dropUnreadablePoints() {
  auto& [points, triangles] = m_file.soup;
  std::vector<std::uint32_t> renumbered(points.size(), kNone);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!step()) return false;
    if (!isReadable(points[i])) continue;
    points[kept] = points[i];
    renumbered[i] = kept++;
  }
  points.resize(kept);
  for (Triangle& triangle : triangles) {
    if (!step()) return false;
    for (std::uint32_t& corner : triangle) corner = renumbered[corner];
  }
  return true;
}

void MeshAssembly::lose(LostAttribute attribute, std::string_view name) {
  m_lost.insert(attribute);
  constexpr std::size_t kMostNames = 5, kLongestName = 40;
  std::vector<std::string>& names = m_file.lostOther;
  if (attribute != LostAttribute::Other || std::find(names.begin(), names.end(), name) != names.end()) return;
  const bool isPlain = !name.empty() && name.size() <= kLongestName &&
                       std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c < 127; });
  if (isPlain && names.size() < kMostNames)
    names.emplace_back(name);
  else
    m_hasUnlistedLoss = true;
}

Result<MeshFile> MeshAssembly::finish(NumberType numbers, bool hasUnit) {
  const bool whole = !m_failure && resolveDeferred() && (m_unreadablePoints == 0 || dropUnreadablePoints());
  if (!whole) return *m_failure;
  // Faces that wait for their vertices are checked late.
  auto& damage = m_file.damage;
  std::stable_sort(damage.begin(), damage.end(),
                   [](const Error& a, const Error& b) { return a.position.value < b.position.value; });
  if (m_file.soup.triangles.empty()) {
    const InputPosition first = m_partial && !damage.empty() ? damage.front().position : InputPosition();
    const bool isKnown = first.kind != InputPosition::Kind::None;
    return Error{isKnown ? MeshFileError::NothingReadable : MeshError::NoTriangles, {}, first, {}};
  }
  m_file.numbers = numbers;
  m_file.hasUnit = hasUnit;
  m_file.lost.assign(m_lost.begin(), m_lost.end());
  if (m_hasUnlistedLoss) m_file.lostOther.emplace_back();
  m_progress.set(1.0);
  return std::move(m_file);
}

}  // namespace handwheel
