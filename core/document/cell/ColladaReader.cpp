// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/ColladaReader.h"

#include "document/cell/ColladaGeometry.h"
#include "mesh/structure/MeshErrors.h"
#include "xml/Xml.h"
#include "xml/XmlNumbers.h"

#include <map>
#include <new>
#include <numbers>

namespace handwheel {

namespace {

constexpr XmlLimits kColladaLimits{std::size_t{256} << 20, 500'000, 64};
constexpr std::size_t kMostTriangles = 20'000'000;
constexpr std::size_t kMostPoints = 20'000'000;
constexpr int kMostNodes = 100'000;    // instances counted as often as they are placed
constexpr int kMostSteps = 2'000'000;  // elements looked at in them
constexpr int kDeepestInstance = 64;   // Depth of nodes in nodes

using Placement = Eigen::Affine3d;

bool numbersOf(const XmlElement& element, std::span<double> numbers) {
  return parseNumbers(element.text, numbers).hasValue();
}

// One step of a node's transformation; none where the element is none, or malformed.
std::optional<Placement> stepOf(const XmlElement& element) {
  Placement step = Placement::Identity();
  std::array<double, 16> v{};
  if (element.name == "matrix" && numbersOf(element, v)) {
    step.matrix() = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(v.data());
    if (v[12] != 0.0 || v[13] != 0.0 || v[14] != 0.0 || v[15] != 1.0) return {};
    return step;
  }
  if (element.name == "translate" && numbersOf(element, std::span(v).first(3)))
    return step.translate(Vec3(v[0], v[1], v[2]));
  if (element.name == "scale" && numbersOf(element, std::span(v).first(3))) return step.scale(Vec3(v[0], v[1], v[2]));
  if (element.name == "rotate" && numbersOf(element, std::span(v).first(4))) {
    const Vec3 axis = Vec3(v[0], v[1], v[2]).stableNormalized();
    if (axis.isZero()) return {};
    return step.rotate(Eigen::AngleAxisd(v[3] * std::numbers::pi / 180.0, axis));
  }
  return {};
}

bool isStep(std::string_view name) {
  return name == "matrix" || name == "translate" || name == "scale" || name == "rotate" || name == "lookat" ||
         name == "skew";
}

class Scene {
 public:
  Scene(const XmlElement& root, ColladaMesh& result, Progress progress)
      : m_root(root), m_result(result), m_progress(progress), m_ids(root), m_geometry(m_ids, result.damage, progress) {}

  void read() {
    const double unit = readUnit();
    const XmlElement* scene = m_root.child("scene");
    const XmlElement* instance = scene ? scene->child("instance_visual_scene") : nullptr;
    const XmlElement* nodes = instance ? m_ids.referred(*instance, "url", "visual_scene") : nullptr;
    const XmlElement* library = m_root.child("library_visual_scenes");
    if (!nodes && library) nodes = library->child("visual_scene");
    if (nodes) addChildren(*nodes, Placement(Eigen::Scaling(unit)), 0);
  }

 private:
  double readUnit() {
    const XmlElement* asset = m_root.child("asset");
    const XmlElement* unit = asset ? asset->child("unit") : nullptr;
    const std::string* metres = unit ? unit->attribute("meter") : nullptr;
    if (!metres) return 1.0;
    double value = 0.0;
    if (parseNumbers(*metres, {&value, 1}) && value > 0.0) return value;
    m_geometry.note(malformed(*unit, "it is not a length; metres are assumed"));
    return 1.0;
  }

  void addNode(const XmlElement& node, Placement placement, int depth) {
    if (++m_nodes > kMostNodes || depth > kDeepestInstance || m_progress.cancelled()) return giveUp(node);
    m_steps += static_cast<int>(node.children.size());
    if (m_steps > kMostSteps) return giveUp(node);
    for (const XmlElement& child : node.children) {
      if (!isStep(child.name)) continue;
      if (const auto step = stepOf(child))
        placement = placement * *step;
      else
        m_geometry.note(malformed(child, "its transformation is not valid"));
    }
    addChildren(node, placement, depth);
  }

  void addChildren(const XmlElement& node, const Placement& placement, int depth) {
    for (const XmlElement& child : node.children) {
      if (m_gaveUp) return;
      if (child.name == "node") addNode(child, placement, depth + 1);
      if (child.name == "instance_node") {
        const XmlElement* target = m_ids.referred(child, "url", "node");
        if (target) addNode(*target, placement, depth + 1);
      }
      if (child.name == "instance_geometry") {
        const XmlElement* target = m_ids.referred(child, "url", "geometry");
        if (target) addGeometry(*target, placement);
      }
      if (child.name == "instance_controller")
        m_geometry.note({ErrorCode::Unsupported, {"a skinned mesh"}, InputPosition::line(child.line), {}});
    }
  }

  void addGeometry(const XmlElement& geometry, const Placement& placement) {
    const auto [known, isNew] = m_soups.try_emplace(&geometry);
    if (isNew) known->second = m_geometry.read(geometry);
    TriangleSoup& own = known->second;
    TriangleSoup& soup = m_result.soup;
    if (own.triangles.empty()) return void(own = {});
    if (soup.triangles.size() + own.triangles.size() > kMostTriangles ||
        soup.points.size() + own.points.size() > kMostPoints)
      return giveUp(geometry);
    const auto base = static_cast<std::uint32_t>(soup.points.size());
    for (const Vec3& p : own.points) soup.points.push_back(placement * p);
    const bool mirrors = placement.linear().determinant() < 0.0;
    for (const Triangle& t : own.triangles)
      soup.triangles.push_back({base + t[0], base + t[mirrors ? 2 : 1], base + t[mirrors ? 1 : 2]});
  }

  void giveUp(const XmlElement& where) {
    if (!m_gaveUp) m_geometry.note(malformed(where, "it is instanced too often, or within itself"));
    m_gaveUp = true;
  }

  const XmlElement& m_root;
  ColladaMesh& m_result;
  Progress m_progress;
  ColladaIds m_ids;
  ColladaGeometry m_geometry;
  std::map<const XmlElement*, TriangleSoup> m_soups;
  int m_nodes = 0;
  int m_steps = 0;
  bool m_gaveUp = false;
};

}  // namespace

Result<ColladaMesh> readCollada(std::string_view bytes, Progress progress) {
  try {
    const Result<XmlElement> root = readXml(bytes, kColladaLimits, progress.part(0.0, 0.7));
    if (!root) return root.error();
    if (root->name != "COLLADA") return malformed(*root, "a COLLADA document was expected");
    ColladaMesh mesh;
    Scene(*root, mesh, progress.part(0.7, 1.0)).read();
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (mesh.soup.triangles.empty()) return Error{MeshError::NoTriangles, {}, {}, {}};
    return mesh;
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  }
}

bool looksLikeCollada(std::string_view head) {
  return head.find("<COLLADA") != head.npos;
}

}  // namespace handwheel
