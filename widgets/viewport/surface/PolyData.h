// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/surface/SurfaceGeometry.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <QColor>
#include <span>

namespace handwheel {

// Returns vtkPolyData of triangles with points, normals (x y z …) and three corners each.
vtkSmartPointer<vtkPolyData> toPolyData(const std::vector<float>& positions, const std::vector<float>& normals,
                                        const std::vector<std::int32_t>& corners);
// Sets the colours of the points: r g b for each, in order.
void setColours(vtkPolyData& data, const std::vector<unsigned char>& colours);
// Converts surface geometry to vtkPolyData.
vtkSmartPointer<vtkPolyData> toPolyData(const SurfaceGeometry& geometry);

// Converts the live faces of a range to vtkPolyData. The result has no normals and no colours, and its points are
// relative to an origin near the model.
vtkSmartPointer<vtkPolyData> facesOf(const HalfEdgeMesh& mesh, std::span<const Face> faces, const Vec3& origin);

// Builds vtkPolyData from coloured points, lines and triangles. Positions are relative to an origin near the model.
class PolyDataBuilder {
 public:
  explicit PolyDataBuilder(const Vec3& origin) : m_origin(origin) {}

  std::int32_t addPoint(const Vec3& p, const QColor& colour);
  void addCell(std::initializer_list<std::int32_t> corners);
  bool isEmpty() const { return m_ends.size() < 2; }

  // All cells must be of one kind: points, segments or triangles.
  enum class Kind { Points, Segments, Triangles };
  vtkSmartPointer<vtkPolyData> build(Kind kind) const;

 private:
  Vec3 m_origin;
  std::vector<float> m_positions;
  std::vector<unsigned char> m_colours;  // r g b a
  std::vector<std::int32_t> m_corners;
  std::vector<std::int32_t> m_ends{0};
};

}  // namespace handwheel
