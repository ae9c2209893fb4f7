// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/simplify/QuadricDecimation.h"

#include "mesh/openmesh/OpenMeshCopy.h"
#include "mesh/simplify/CollapseShape.h"
#include "mesh/simplify/VertexConstraints.h"
#include "mesh/structure/MeshBounds.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cassert>
#include <cmath>

namespace handwheel {
namespace {

using OpenMeshModule = OpenMesh::Decimater::ModBaseT<OpenMeshSurface>;
using QuadricModule = OpenMesh::Decimater::ModQuadricT<OpenMeshSurface>;

constexpr std::size_t kCollapsesPerReport = 256;

// On flat faces rounding makes the error negative, which the decimater treats as "not allowed": the cheapest collapses
// would never be made. Errors are of the unit box, so rounding is far from its -1.
class RoundedQuadrics : public QuadricModule {
 public:
  using QuadricModule::QuadricModule;
  using Handle = OpenMesh::Decimater::ModHandleT<RoundedQuadrics>;
  float collapse_priority(const CollapseInfo& c) override {
    const float error = QuadricModule::collapse_priority(c);
    return error < 0.0f && error > -0.5f ? 0.0f : error;
  }
};

// Checks that OpenMesh lacks: shapes, creases that would become one, seams. Also reports the progress.
class CollapseGuard : public OpenMeshModule {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<CollapseGuard>;
  explicit CollapseGuard(OpenMeshSurface& surface) : OpenMeshModule(surface, true) {}

  void begin(OpenMeshCopy& copy, const HalfEdgeMesh& original, std::size_t goal, const Progress& progress) {
    m_copy = &copy;
    m_original = &original;
    m_progress = progress;
    m_toGo = static_cast<double>(copy.surface().n_faces() - std::min(goal, copy.surface().n_faces()));
  }

  float collapse_priority(const CollapseInfo& c) override {
    const bool isAllowed = !mergesCreases(c.v0vl, c.vlv1) && !mergesCreases(c.vrv0, c.v1vr) && keepsShapes(c);
    return isAllowed ? float(LEGAL_COLLAPSE) : float(ILLEGAL_COLLAPSE);
  }

  // Either of the two edges that become one may remain.
  void preprocess_collapse(const CollapseInfo& c) override {
    m_left = marksOf(c.v0vl, c.vlv1);
    m_right = marksOf(c.vrv0, c.v1vr);
  }

  void postprocess_collapse(const CollapseInfo& c) override {
    mark(c.v1, c.vl, m_left);
    mark(c.v1, c.vr, m_right);
    m_gone += 1.0 + (c.fl.is_valid() && c.fr.is_valid());
    if (++m_collapses % kCollapsesPerReport == 0) m_progress.set(m_gone / m_toGo);
  }

 private:
  struct Marks {
    bool isCrease = false, isSeam = false;
  };

  bool isCrease(OpenMesh::HalfedgeHandle h) { return mesh().status(mesh().edge_handle(h)).feature(); }
  bool isSeam(OpenMesh::HalfedgeHandle h) const { return m_copy->isSeam(m_copy->surface().edge_handle(h)); }
  bool mergesCreases(OpenMesh::HalfedgeHandle a, OpenMesh::HalfedgeHandle b) {
    return a.is_valid() && isCrease(a) && isCrease(b);
  }
  Marks marksOf(OpenMesh::HalfedgeHandle a, OpenMesh::HalfedgeHandle b) {
    return a.is_valid() ? Marks{isCrease(a) || isCrease(b), isSeam(a) || isSeam(b)} : Marks();
  }

  void mark(OpenMesh::VertexHandle from, OpenMesh::VertexHandle to, const Marks& marks) {
    if (!marks.isCrease && !marks.isSeam) return;
    const auto edge = mesh().edge_handle(mesh().find_halfedge(from, to));
    if (marks.isCrease) mesh().status(edge).set_feature(true);
    if (marks.isSeam) m_copy->setSeam(edge);
  }

  const Vec3& positionOf(OpenMesh::VertexHandle v) const {
    return m_original->position(m_copy->vertexOf(std::size_t(v.idx())));
  }

  // Returns the position in the mesh, not in the copy.
  bool keepsShapes(const CollapseInfo& c) {
    m_before.clear();
    m_after.clear();
    const Vec3 &from = positionOf(c.v0), &to = positionOf(c.v1);
    for (auto h = mesh().voh_iter(c.v0); h.is_valid(); ++h) {
      const auto face = mesh().face_handle(*h);
      if (!face.is_valid() || face == c.fl || face == c.fr) continue;
      const Vec3& second = positionOf(mesh().to_vertex_handle(*h));
      const Vec3& third = positionOf(mesh().to_vertex_handle(mesh().next_halfedge_handle(*h)));
      m_before.push_back({from, second, third});
      m_after.push_back({to, second, third});
    }
    return keepsShape(m_before, m_after);
  }

  OpenMeshCopy* m_copy = nullptr;
  const HalfEdgeMesh* m_original = nullptr;
  Progress m_progress;
  double m_toGo = 1.0, m_gone = 0.0;
  std::size_t m_collapses = 0;
  Marks m_left, m_right;
  std::vector<TrianglePoints> m_before, m_after;
};

// In the middle of the unit box: quadrics lose digits with the square of the distance from the origin, and the
// decimater compares their errors as floats.
void moveToUnitBox(OpenMeshCopy& copy, const HalfEdgeMesh& mesh) {
  const Box box = boundsOf(mesh);
  if (box.isEmpty()) return;
  const Vec3 middle = 0.5 * box.min() + 0.5 * box.max();
  int exponent = 0;
  std::frexp((0.5 * box.max() - 0.5 * box.min()).maxCoeff(), &exponent);
  for (std::size_t i = 0; i < copy.takenVertices(); ++i) {
    const Vec3 p = mesh.position(copy.vertexOf(i)) - middle;
    copy.surface().set_point(OpenMesh::VertexHandle(int(i)),
                             openMeshPoint(p.unaryExpr([&](double x) { return std::ldexp(x, -exponent); })));
  }
}

void hold(OpenMeshCopy& copy, const HalfEdgeMesh& mesh, const DecimationOptions& options, const Progress& progress) {
  const VertexConstraints constraints(mesh, options.keepBorders, options.creaseAngle, progress);
  if (progress.cancelled()) return;
  OpenMeshSurface& surface = copy.surface();
  for (const auto v : surface.vertices()) {
    const VertexConstraint constraint = constraints.of(copy.vertexOf(std::size_t(v.idx())));
    surface.status(v).set_feature(constraint == VertexConstraint::Crease);
    surface.status(v).set_locked(constraint == VertexConstraint::Fixed || surface.valence(v) > kMostFacesOfCollapse);
  }
  for (const auto f : surface.faces()) {
    const HalfEdge first = 3 * copy.faceOf(std::size_t(f.idx()));
    auto h = surface.halfedge_handle(f);  // the first corner comes first, as it was taken
    for (std::uint32_t k = 0; k < 3; ++k, h = surface.next_halfedge_handle(h))
      if (constraints.isCrease(first + k)) surface.status(surface.edge_handle(h)).set_feature(true);
  }
}

void collapse(OpenMeshCopy& copy, const HalfEdgeMesh& mesh, std::size_t faces, const Progress& progress) {
  OpenMesh::Decimater::DecimaterT<OpenMeshSurface> decimater(copy.surface());
  RoundedQuadrics::Handle quadrics;
  CollapseGuard::Handle guard;
  decimater.add(quadrics);
  decimater.add(guard);
  decimater.module(guard).begin(copy, mesh, faces, progress);
  [[maybe_unused]] const bool isReady = decimater.initialize();
  assert(isReady);
  decimater.decimate_to_faces(0, faces);
}

}  // namespace

OpenMeshRefusal decimateByQuadrics(HalfEdgeMesh& mesh, const DecimationOptions& options, Progress progress) {
  assert(!options.error && !options.avoidIntersections);
  OpenMeshCopy copy;
  const OpenMeshRefusal refusal = copy.take(mesh, progress.part(0.0, 0.1));
  if (refusal != OpenMeshRefusal::None || progress.cancelled()) return refusal;
  try {
    copy.surface().poll(progress);
    hold(copy, mesh, options, progress.part(0.1, 0.2));
    moveToUnitBox(copy, mesh);
    collapse(copy, mesh, options.faces, progress.part(0.2, 0.9));
    for (std::size_t i = 0; i < copy.takenVertices(); ++i)
      copy.surface().set_point(OpenMesh::VertexHandle(int(i)), openMeshPoint(mesh.position(copy.vertexOf(i))));
    copy.bringBack(mesh, progress.part(0.9, 1.0));
  } catch (const OpenMeshSurface::Cancelled&) {
  }
  return OpenMeshRefusal::None;
}

}  // namespace handwheel
