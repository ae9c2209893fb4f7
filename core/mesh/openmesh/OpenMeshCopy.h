// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/openmesh/OpenMeshRefusal.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <span>

// Converts meshes to OpenMesh and back. This header contains all such conversions. It is included only by source files,
// never by headers, so that no other code depends on the types of OpenMesh (docs/adr/0028-openmesh.md).
namespace handwheel {

struct OpenMeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::Status);
};

// A mesh of OpenMesh whose algorithms can be cancelled. They report no progress, but all their loops that do more than
// assign a number call one of the functions below. These poll the cancel flag, count effort, and throw Cancelled if the
// flag is set. The mesh must not be used after that exception.
class OpenMeshSurface : public OpenMesh::TriMesh_ArrayKernelT<OpenMeshTraits> {
  using Base = OpenMesh::TriMesh_ArrayKernelT<OpenMeshTraits>;

 public:
  struct Cancelled {};
  static constexpr std::size_t kCallsPerPoll = 1024;
  static constexpr std::size_t kCallsPerStep =
      8;  // calls per step of WorkBudget: each takes about 0.1 µs with the work between

  void poll(const Progress& progress) { m_progress = progress; }

  const Point& point(VertexHandle v) const {
    countCall();
    return Base::point(v);
  }
  void set_point(VertexHandle v, const Point& p) {
    countCall();
    Base::set_point(v, p);
  }
  // Returns the status of an element. OpenMesh calls this function in loops over selected or tagged elements.
  template <class Handle>
  decltype(auto) status(Handle h) {
    countCall();
    return Base::status(h);
  }
  template <class Handle>
  decltype(auto) status(Handle h) const {
    countCall();
    return Base::status(h);
  }
  // Returns a half-edge of an edge. OpenMesh calls this function in loops over edges.
  using Base::halfedge_handle;
  HalfedgeHandle halfedge_handle(EdgeHandle e, unsigned int side) const {
    countCall();
    return Base::halfedge_handle(e, side);
  }
  OpenMesh::SmartHalfedgeHandle halfedge_handle(OpenMesh::SmartEdgeHandle e, unsigned int side) const {
    countCall();
    return Base::halfedge_handle(e, side);
  }
  // Adds an edge. OpenMesh calls this function in loops that split edges and faces.
  HalfedgeHandle new_edge(VertexHandle from, VertexHandle to) {
    countCall();
    return Base::new_edge(from, to);
  }
  // Do nothing: OpenMesh's smoother needs normals only to smooth in the tangential or the normal direction alone, which
  // Handwheel does not use.
  void update_face_normals() {}
  void update_vertex_normals() {}

 private:
  void countCall() const {
    if (++m_calls % kCallsPerPoll != 0) return;
    m_progress.spend(kCallsPerPoll / kCallsPerStep);
    if (m_progress.cancelled()) throw Cancelled();
  }

  Progress m_progress;
  mutable std::size_t m_calls = 0;
};

// A copy of a mesh for OpenMesh. Its faces and vertices are in the order of the live faces and vertices of the mesh.
class OpenMeshCopy {
 public:
  // Copies a mesh in O(faces). If the mesh is refused, nothing is built. The function must be called only once; the
  // copy is invalid if the mesh was refused or the function was cancelled.
  OpenMeshRefusal take(const HalfEdgeMesh& mesh, Progress progress = {});

  // Writes the changed copy back into the original mesh, in O(faces). Remaining elements keep their numbers, and faces
  // the order of their unchanged corners. New faces and vertices follow the last slot, and vertices without faces are
  // omitted. If cancelled, the mesh is unchanged, and the function returns false or throws OpenMeshSurface::Cancelled.
  bool bringBack(HalfEdgeMesh& mesh, Progress progress = {}) const;

  OpenMeshSurface& surface() { return m_surface; }
  const OpenMeshSurface& surface() const { return m_surface; }
  Face faceOf(std::size_t i) const { return m_faceOf[i]; }
  Vertex vertexOf(std::size_t i) const { return m_vertexOf[i]; }
  std::size_t takenVertices() const { return m_vertexOf.size(); }
  // Returns true if more than two faces meet at an open edge. Algorithms that merge edges must update this mark with
  // setSeam().
  bool isSeam(OpenMesh::EdgeHandle e) const { return m_surface.property(m_isSeam, e); }
  void setSeam(OpenMesh::EdgeHandle e) { m_surface.property(m_isSeam, e) = true; }
  bool hasSeams() const { return m_hasSeams; }

 private:
  bool link(const HalfEdgeMesh& mesh, std::span<const Triangle> triangles, const Progress& progress);
  Triangle cornersOf(OpenMesh::FaceHandle f, std::span<const Vertex> vertexOf) const;

  OpenMeshSurface m_surface;
  OpenMesh::EPropHandleT<bool> m_isSeam;
  bool m_hasSeams = false;
  std::vector<Face> m_faceOf;      // indexed by face numbers of OpenMesh
  std::vector<Vertex> m_vertexOf;  // indexed by vertex numbers of OpenMesh
};

inline OpenMesh::Vec3d openMeshPoint(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}
inline Vec3 pointOf(const OpenMesh::Vec3d& p) {
  return {p[0], p[1], p[2]};
}

}  // namespace handwheel
