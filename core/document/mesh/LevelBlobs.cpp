// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/LevelBlobs.h"

#include "base/JsonText.h"
#include "document/container/Blobs.h"
#include "mesh/structure/MeshValidator.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

namespace handwheel {
namespace {

const std::string kFolder = "mesh/levels/";
constexpr std::size_t kLevelFaceNumbers = 7;
constexpr std::size_t kPointNumbers = 3;

std::string levelName(std::size_t level) {
  char number[24];
  std::snprintf(number, sizeof number, "%04zu", level);
  return kFolder + number;
}

// Returns the vertices of these faces in ascending order.
std::vector<Vertex> verticesOf(const HalfEdgeMesh& mesh, const std::vector<Face>& faces) {
  std::vector<Vertex> vertices;
  vertices.reserve(3 * faces.size());
  for (const Face f : faces) vertices.insert(vertices.end(), mesh.triangle(f).begin(), mesh.triangle(f).end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

nlohmann::json writeLevel(const PatchLevels& levels, std::size_t level, Container& container) {
  const HalfEdgeMesh& mesh = levels.mesh(level);
  const std::string name = levelName(level);
  const FirstSlots next = levels.firstAdded(level + 1);
  FaceSelection patch = levels.patch(level);
  patch.dropDead(mesh);
  const std::vector<Face> faces = patch.faces();
  std::vector<std::uint32_t> rows;
  rows.reserve(kLevelFaceNumbers * faces.size());
  for (const Face f : faces) {
    const Triangle& t = mesh.triangle(f);
    rows.insert(rows.end(), {f, t[0], t[1], t[2]});
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) rows.push_back(mesh.opposite(h));
  }
  writeArray<std::uint32_t>(container, name + "/faces", rows, kLevelFaceNumbers);
  const std::vector<Vertex> vertices = verticesOf(mesh, faces);
  std::vector<double> points;
  points.reserve(kPointNumbers * vertices.size());
  for (const Vertex v : vertices) {
    const Vec3& p = mesh.position(v);
    points.insert(points.end(), {p.x(), p.y(), p.z()});
  }
  writeArray<double>(container, name + "/points", points, kPointNumbers);
  return {{"vertices", mesh.vertexSlots()}, {"faces", mesh.faceSlots()},  {"patch", faces.size()},
          {"points", vertices.size()},      {"next_vertex", next.vertex}, {"next_face", next.face}};
}

// Without the key, as levels were saved that no edit had followed: behind the others.
std::uint64_t nextSlot(const nlohmann::json& level, const char* key, std::uint64_t otherwise) {
  return level.is_object() && level.contains(key) ? countAt(level, key) : otherwise;
}

// A level of a patch made from the mesh of the next finer one. Any number in it may be anything.
class LevelReading {
 public:
  LevelReading(const nlohmann::json& level, const std::string& name, const Container& container)
      : m_vertexSlots(countAt(level, "vertices")),
        m_faceSlots(countAt(level, "faces")),
        m_nextVertex(nextSlot(level, "next_vertex", m_vertexSlots)),
        m_nextFace(nextSlot(level, "next_face", m_faceSlots)),
        m_faces(readArray<std::uint32_t>(container, name + "/faces", countAt(level, "patch"), kLevelFaceNumbers)),
        m_points(readArray<double>(container, name + "/points", countAt(level, "points"), kPointNumbers)) {}

  // False where the numbers make no mesh. A mesh it may be and yet no level: PatchLevels::addBelow() knows.
  bool make(const HalfEdgeMesh& finer, Progress progress) {
    if (!m_faces.lost.empty() || !m_points.lost.empty()) return false;
    if (m_vertexSlots > finer.vertexSlots() || m_faceSlots > finer.faceSlots()) return false;
    if (m_nextVertex > m_vertexSlots || m_nextFace > m_faceSlots || !readOrder()) return false;
    mesh = finer;
    removeAdded();
    mesh.truncate(static_cast<std::size_t>(m_vertexSlots), static_cast<std::size_t>(m_faceSlots));
    return setFaces() && setPoints() && validate(mesh, progress).empty();
  }
  // To be asked for after make(): both are slots, or the number after the last.
  FirstSlots nextSlots() const { return {static_cast<Vertex>(m_nextVertex), static_cast<Face>(m_nextFace)}; }

  HalfEdgeMesh mesh;
  FaceSelection patch;

 private:
  const std::uint32_t* row(std::size_t i) const { return &m_faces.values[kLevelFaceNumbers * i]; }

  bool readOrder() {
    for (std::size_t i = 0; i < m_faces.values.size() / kLevelFaceNumbers; ++i) {
      const Face f = row(i)[0];
      if (f >= m_faceSlots || (!m_order.empty() && f <= m_order.back())) return false;
      m_order.push_back(f);
      patch.add(f);
    }
    return !m_order.empty();
  }

  // The faces that the finer level has more, where others came behind them: two for each edge within the patch.
  void removeAdded() {
    std::uint64_t end = m_nextFace;
    for (std::size_t i = 0; i < m_order.size(); ++i)
      end += static_cast<std::uint64_t>(std::count_if(row(i) + 4, row(i) + 7, [&](HalfEdge o) {
        return o < static_cast<HalfEdge>(Open::Seam) && patch.contains(HalfEdgeMesh::face(o));
      }));
    for (auto f = static_cast<Face>(m_nextFace); f < std::min(end, m_faceSlots); ++f) mesh.removeFace(f);
  }

  bool setFaces() {
    for (std::size_t i = 0; i < m_order.size(); ++i) {
      const Triangle corners = {row(i)[1], row(i)[2], row(i)[3]};
      if (std::any_of(corners.begin(), corners.end(), [&](Vertex v) { return v >= mesh.vertexSlots(); })) return false;
      mesh.setTriangle(m_order[i], corners);
    }
    for (std::size_t i = 0; i < m_order.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const HalfEdge h = 3 * m_order[i] + k, o = row(i)[4 + k];
        mesh.setOpposite(h, o);
        if (!mesh.hasOpposite(h)) continue;
        if (o >= mesh.halfEdgeSlots()) return false;
        if (!patch.contains(HalfEdgeMesh::face(o))) mesh.setOpposite(o, h);  // there it was another part of the face
      }
    }
    return true;
  }

  bool setPoints() {
    const std::vector<Vertex> vertices = verticesOf(mesh, m_order);
    if (kPointNumbers * vertices.size() != m_points.values.size()) return false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const double* p = &m_points.values[kPointNumbers * i];
      mesh.setPosition(vertices[i], {p[0], p[1], p[2]});
    }
    return true;
  }

  const std::uint64_t m_vertexSlots;
  const std::uint64_t m_faceSlots;
  const std::uint64_t m_nextVertex;
  const std::uint64_t m_nextFace;
  const ReadArray<std::uint32_t> m_faces;
  const ReadArray<double> m_points;
  std::vector<Face> m_order;
};

// From fine to coarse, each against the one before, so that little is made of what is not true.
std::optional<PatchLevels> levelsOf(const nlohmann::json& list, const Container& container, const HalfEdgeMesh& mesh,
                                    Progress progress) {
  PatchLevels levels(mesh, {});
  for (std::size_t left = list.size(); left > 0 && !progress.cancelled(); --left) {
    LevelReading level(list[left - 1], levelName(left - 1), container);
    const double size = static_cast<double>(list.size()), done = static_cast<double>(list.size() - left);
    if (!level.make(levels.mesh(0), progress.part(done / size, (done + 1.0) / size))) return std::nullopt;
    if (!levels.addBelow(std::move(level.mesh), std::move(level.patch), level.nextSlots())) return std::nullopt;
  }
  if (progress.cancelled()) return std::nullopt;
  return levels;
}

}  // namespace

void writeLevelBlobs(const PatchLevels* levels, Container& container) {
  nlohmann::json& list = (*container.manifest)["document"]["levels"] = nlohmann::json::array();
  for (std::size_t level = 0; levels && level < levels->finest(); ++level)
    list.push_back(writeLevel(*levels, level, container));
}

std::shared_ptr<const PatchLevels> readLevelBlobs(const nlohmann::json& document, const Container& container,
                                                  const HalfEdgeMesh* mesh, std::vector<Error>& damage,
                                                  Progress progress) {
  const auto list = document.find("levels");
  if (list == document.end() || !list->is_array() || list->empty()) return nullptr;
  // A program that does not know of levels keeps their key and drops their blobs.
  const auto first = container.blobs.lower_bound(kFolder);
  if (first == container.blobs.end() || !first->first.starts_with(kFolder)) return nullptr;
  std::optional<PatchLevels> levels;
  if (mesh) levels = levelsOf(*list, container, *mesh, progress);
  if (levels || progress.cancelled()) return levels ? std::make_shared<const PatchLevels>(std::move(*levels)) : nullptr;
  damage.push_back({ErrorCode::ElementMalformed, {"levels", "they do not fit the mesh"}, {}, {}});
  return nullptr;
}

}  // namespace handwheel
