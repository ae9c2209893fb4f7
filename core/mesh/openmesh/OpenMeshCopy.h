// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/openmesh/OpenMeshRefusal.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <span>

// Converts meshes to OpenMesh and back. This is the only place where that is done. Included by sources only, never by
// headers, so that nothing else sees its types (docs/adr/0028-openmesh.md).
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
// set a number call one of the functions below. These poll the cancel flag, count as effort, and throw Cancelled.
// The mesh must not be used afterwards.
class OpenMeshSurface : public OpenMesh::TriMesh_ArrayKernelT<OpenMeshTraits> {
  using Base = OpenMesh::TriMesh_ArrayKernelT<OpenMeshTraits>;

 public:
  struct Cancelled {};
  static constexpr std::size_t kCallsPerPoll = 1024;

  void poll(const Progress& progress) { m_progress = progress; }

  const Point& point(VertexHandle v) const {
    countCall();
    return Base::point(v);
  }
  void set_point(VertexHandle v, const Point& p) {
    countCall();
    Base::set_point(v, p);
  }
  // Loops over what is selected or tagged.
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
  // Loops over edges.
  using Base::halfedge_handle;
  HalfedgeHandle halfedge_handle(EdgeHandle e, unsigned int side) const {
    countCall();
    return Base::halfedge_handle(e, side);
  }
  OpenMesh::SmartHalfedgeHandle halfedge_handle(OpenMesh::SmartEdgeHandle e, unsigned int side) const {
    countCall();
    return Base::halfedge_handle(e, side);
  }
  // Loops that split edges and faces.
  HalfedgeHandle new_edge(VertexHandle from, VertexHandle to) {
    countCall();
    return Base::new_edge(from, to);
  }
  // The smoother computes normals, which only the components that are not used here need.
  void update_face_normals() {}
  void update_vertex_normals() {}

 private:
  void countCall() const {
    if (++m_calls % kCallsPerPoll != 0) return;
    m_progress.spend(kCallsPerPoll);
    if (m_progress.cancelled()) throw Cancelled();
  }

  Progress m_progress;
  mutable std::size_t m_calls = 0;
};

// A copy of a mesh for OpenMesh. Faces and vertices have the order of the live ones of the mesh.
class OpenMeshCopy {
 public:
  // Makes the copy, in O(faces). A refusal is found before anything is built. To be called once; the copy is of no use
  // when it was refused or cancelled.
  OpenMeshRefusal take(const HalfEdgeMesh& mesh, Progress progress = {});

  // Brings what has become of the copy back into the mesh that it was taken of, in O(faces). What is left keeps its
  // number, and a face the order of its corners as far as it has the same ones; new faces and vertices come after the
  // last slot, and vertices that no face has are left out. A cancel changes nothing: false is returned, or, where the
  // surface polls, Cancelled thrown.
  bool bringBack(HalfEdgeMesh& mesh, Progress progress = {}) const;

  OpenMeshSurface& surface() { return m_surface; }
  const OpenMeshSurface& surface() const { return m_surface; }
  Face faceOf(std::size_t i) const { return m_faceOf[i]; }
  Vertex vertexOf(std::size_t i) const { return m_vertexOf[i]; }
  std::size_t takenVertices() const { return m_vertexOf.size(); }
  // Whether more than two faces meet at an open edge. To be kept up by whoever merges edges.
  bool isSeam(OpenMesh::EdgeHandle e) const { return m_surface.property(m_isSeam, e); }
  void setSeam(OpenMesh::EdgeHandle e) { m_surface.property(m_isSeam, e) = true; }
  bool hasSeams() const { return m_hasSeams; }

 private:
  bool link(const HalfEdgeMesh& mesh, std::span<const Triangle> triangles, const Progress& progress);
  Triangle cornersOf(OpenMesh::FaceHandle f, std::span<const Vertex> vertexOf) const;

  OpenMeshSurface m_surface;
  OpenMesh::EPropHandleT<bool> m_isSeam;
  bool m_hasSeams = false;
  std::vector<Face> m_faceOf;      // by the numbers of OpenMesh
  std::vector<Vertex> m_vertexOf;  // the same
};

inline OpenMesh::Vec3d openMeshPoint(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}
inline Vec3 pointOf(const OpenMesh::Vec3d& p) {
  return {p[0], p[1], p[2]};
}

}  // namespace handwheel
