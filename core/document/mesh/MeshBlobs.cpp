// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/MeshBlobs.h"

#include "base/JsonText.h"
#include "document/container/ArchiveErrors.h"
#include "document/container/Blobs.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/MeshErrors.h"
#include "mesh/structure/MeshValidator.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

const std::string kPositions = "mesh/positions";
const std::string kFaces = "mesh/faces";
constexpr std::size_t kPositionNumbers = 3;
constexpr std::size_t kFaceNumbers = 6;

// The numbers of an array of slots; what is lost reads as the filler.
template <class T>
ReadArray<T> readSlots(const nlohmann::json& document, const char* countKey, const std::string& name,
                       std::size_t perSlot, T filler, const Container& container) {
  ReadArray<T> read = readArray<T>(container, name, countAt(document, countKey), perSlot);
  for (const IndexRange& range : read.lost) {
    const std::size_t end = std::min(range.end * perSlot, read.values.size());
    for (std::size_t i = range.begin * perSlot; i < end; ++i) read.values[i] = filler;
  }
  return read;
}

std::size_t countOf(const std::vector<IndexRange>& ranges) {
  std::size_t count = 0;
  for (const IndexRange& range : ranges) count += range.end - range.begin;
  return count;
}

bool isFinite(const double* p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// Slot for slot; false when the numbers make no sense together, or cancelled.
bool assemble(const std::vector<double>& positions, const std::vector<std::uint32_t>& faces, HalfEdgeMesh& mesh,
              Progress progress) {
  const std::size_t vertices = positions.size() / kPositionNumbers, count = faces.size() / kFaceNumbers;
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!pollProgress(v, vertices, progress.part(0.0, 0.2))) return false;
    const double* p = &positions[v * kPositionNumbers];
    if (!isFinite(p)) return false;  // even where no face uses it: it would differ from itself
    mesh.addVertex({p[0], p[1], p[2]});
  }
  for (std::size_t f = 0; f < count; ++f) {
    if (!pollProgress(f, count, progress.part(0.2, 0.5))) return false;
    const std::uint32_t* slot = &faces[f * kFaceNumbers];
    const bool isDead = slot[0] == kNone;
    for (std::size_t k = 0; k < 3 && !isDead; ++k) {
      if (slot[k] >= vertices) return false;
      if (slot[3 + k] < static_cast<std::uint32_t>(Open::Seam) && slot[3 + k] >= 3 * count) return false;
    }
    mesh.addSlot({slot[0], slot[1], slot[2]}, {slot[3], slot[4], slot[5]});
  }
  return validate(mesh, progress.part(0.5, 1.0)).empty();
}

// The result is invalid if cancelled.
TriangleSoup readableTriangles(const std::vector<double>& positions, const std::vector<std::uint32_t>& faces,
                               std::size_t& lost, Progress progress) {
  TriangleSoup soup;
  const std::size_t vertices = positions.size() / kPositionNumbers;
  soup.points.reserve(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    const double* p = &positions[v * kPositionNumbers];
    soup.points.push_back(isFinite(p) ? Vec3(p[0], p[1], p[2]) : Vec3(Vec3::Zero()));
  }
  for (std::size_t f = 0; f * kFaceNumbers < faces.size(); ++f) {
    if (!pollProgress(f, faces.size() / kFaceNumbers, progress)) break;
    const std::uint32_t* corner = &faces[f * kFaceNumbers];
    if (corner[0] == kNone) continue;
    const bool isReadable = std::all_of(corner, corner + 3, [&](std::uint32_t v) {
      return v < vertices && isFinite(&positions[v * kPositionNumbers]);
    });
    if (isReadable) {
      soup.triangles.push_back({corner[0], corner[1], corner[2]});
    } else {
      ++lost;
    }
  }
  return soup;
}

// Returns the error that reports a rebuilt mesh.
Error rebuilt(std::size_t read, std::size_t lost) {
  if (lost == 0) return {ErrorCode::ElementMalformed, {"mesh", "its triangles are inconsistent"}, {}, {}};
  return {ErrorCode::DataTruncated, {"triangles", std::to_string(read + lost), std::to_string(read)}, {}, {}};
}

// Returns the reason why no triangle is left: damage of the blobs that hold them, or of the archive as a whole.
Error causeOf(std::size_t lost, const std::vector<Error>& damage) {
  const auto found = std::find_if(damage.begin(), damage.end(), [](const Error& each) {
    const bool isOfEntry = each.code == ArchiveError::EntryDamaged || each.code == ArchiveError::EntryMissing;
    return !isOfEntry || each.arguments[0].starts_with(kFaces) || each.arguments[0].starts_with(kPositions);
  });
  return found == damage.end() ? rebuilt(0, lost) : *found;
}

}  // namespace

void writeMeshBlobs(const HalfEdgeMesh& mesh, Container& container) {
  std::vector<double> positions;
  positions.reserve(mesh.vertexSlots() * kPositionNumbers);
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
    const Vec3& p = mesh.position(v);
    positions.insert(positions.end(), {p.x(), p.y(), p.z()});
  }
  writeArray<double>(container, kPositions, positions, kPositionNumbers);
  std::vector<std::uint32_t> faces;
  faces.reserve(mesh.faceSlots() * kFaceNumbers);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    const Triangle& t = mesh.triangle(f);
    faces.insert(faces.end(), t.begin(), t.end());
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) faces.push_back(mesh.opposite(h));
  }
  writeArray<std::uint32_t>(container, kFaces, faces, kFaceNumbers);
  nlohmann::json& document = (*container.manifest)["document"];
  document["vertices"] = mesh.vertexSlots();
  document["faces"] = mesh.faceSlots();
}

Result<LoadedMesh> readMeshBlobs(const nlohmann::json& document, const Container& container, std::vector<Error>& damage,
                                 Progress progress) {
  const Error cancelled{ErrorCode::Cancelled, {}, {}, {}};
  const auto positions = readSlots(document, "vertices", kPositions, kPositionNumbers, std::nan(""), container);
  progress.set(0.1);
  if (progress.cancelled()) return cancelled;
  const auto faces = readSlots(document, "faces", kFaces, kFaceNumbers, kNone, container);
  if (progress.cancelled()) return cancelled;
  LoadedMesh loaded;
  loaded.isWhole = positions.lost.empty() && faces.lost.empty() &&
                   assemble(positions.values, faces.values, loaded.mesh, progress.part(0.2, 0.6));
  if (progress.cancelled()) return cancelled;
  if (loaded.isWhole) return loaded;
  std::size_t lost = countOf(faces.lost);
  const TriangleSoup soup = readableTriangles(positions.values, faces.values, lost, progress.part(0.6, 0.7));
  if (progress.cancelled()) return cancelled;
  if (soup.triangles.empty() && lost > 0) return causeOf(lost, damage);
  if (soup.triangles.empty()) return Error{MeshError::NoTriangles, {}, {}, {}};
  damage.push_back(rebuilt(soup.triangles.size(), lost));
  BuiltMesh built = buildMesh(soup, progress.part(0.7, 1.0));
  if (progress.cancelled()) return cancelled;
  return LoadedMesh{std::move(built.mesh), std::move(built.report), false};
}

}  // namespace handwheel
