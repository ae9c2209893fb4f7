// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/openmesh/OpenMeshRefusal.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <span>

// The only place where meshes go to OpenMesh and come back. Included by sources only, never by headers, so that nothing
// else sees its types (docs/adr/0028-openmesh.md).
namespace handwheel {

struct OpenMeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::Status);
};

// A mesh of OpenMesh whose algorithms can be cancelled. They know no progress, but all of their loops read or write
// points: there the flag is polled, and thrown is what unwinds them. The mesh is of no use afterwards.
class OpenMeshSurface : public OpenMesh::TriMesh_ArrayKernelT<OpenMeshTraits> {
 public:
  struct Cancelled {};

  void poll(const Progress& progress) { m_progress = progress; }

  const Point& point(VertexHandle v) const {
    look();
    return Base::point(v);
  }
  void set_point(VertexHandle v, const Point& p) {
    look();
    Base::set_point(v, p);
  }

 private:
  using Base = OpenMesh::TriMesh_ArrayKernelT<OpenMeshTraits>;
  static constexpr std::size_t kPointsPerLook = 1024;

  void look() const {
    if (++m_looks % kPointsPerLook == 0 && m_progress.cancelled()) throw Cancelled();
  }

  Progress m_progress;
  mutable std::size_t m_looks = 0;
};

// A copy of a mesh for OpenMesh. Faces and vertices have the order of the live ones of the mesh.
class OpenMeshCopy {
 public:
  // Makes the copy, in O(faces). A refusal is found before anything is built. To be called once; the copy is of no use
  // when it was refused or cancelled.
  OpenMeshRefusal take(const HalfEdgeMesh& mesh, Progress progress = {});

  // Brings what has become of the copy back into the mesh that it was taken of, in O(faces). What is left keeps its
  // number, and a face the order of its corners as far as it has the same ones; new faces and vertices come after the
  // last slot, and vertices that no face has are left out. A cancel changes nothing, and false is returned.
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
