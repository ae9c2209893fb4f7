// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/PolyData.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>
#include <algorithm>
#include <numeric>

namespace handwheel {

namespace {

template <class Array, class T>
vtkSmartPointer<Array> toArray(const std::vector<T>& values, int components) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

void setPositions(vtkPolyData* data, const std::vector<float>& positions) {
  vtkNew<vtkPoints> points;
  points->SetData(toArray<vtkFloatArray>(positions, 3));
  data->SetPoints(points);
}

vtkSmartPointer<vtkCellArray> toCells(const std::vector<std::int32_t>& ends, const std::vector<std::int32_t>& corners) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(toArray<vtkTypeInt32Array>(ends, 1), toArray<vtkTypeInt32Array>(corners, 1));
  return cells;
}

vtkSmartPointer<vtkCellArray> toTriangles(const std::vector<std::int32_t>& corners) {
  std::vector<std::int32_t> ends(corners.size() / 3 + 1);
  for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = static_cast<std::int32_t>(3 * i);
  return toCells(ends, corners);
}

}  // namespace

vtkSmartPointer<vtkPolyData> toPolyData(const std::vector<float>& positions, const std::vector<float>& normals,
                                        const std::vector<std::int32_t>& corners) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  setPositions(data, positions);
  data->GetPointData()->SetNormals(toArray<vtkFloatArray>(normals, 3));
  data->SetPolys(toTriangles(corners));
  return data;
}

void setColours(vtkPolyData& data, const std::vector<unsigned char>& colours) {
  data.GetPointData()->SetScalars(toArray<vtkUnsignedCharArray>(colours, 3));
}

vtkSmartPointer<vtkPolyData> toPolyData(const SurfaceGeometry& geometry) {
  auto data = toPolyData(geometry.positions, geometry.normals, geometry.indices);
  if (!geometry.values.empty()) data->GetPointData()->SetScalars(toArray<vtkFloatArray>(geometry.values, 1));
  return data;
}

vtkSmartPointer<vtkPolyData> facesOf(const HalfEdgeMesh& mesh, std::span<const Face> faces, const Vec3& origin) {
  std::vector<float> positions;
  positions.reserve(9 * faces.size());
  for (const Face f : faces) {
    if (f >= mesh.faceSlots() || !mesh.isLive(f)) continue;
    for (const Vertex v : mesh.triangle(f)) {
      const Eigen::Vector3f p = (mesh.position(v) - origin).cast<float>();
      positions.insert(positions.end(), p.begin(), p.end());
    }
  }
  std::vector<std::int32_t> corners(positions.size() / 3);
  std::iota(corners.begin(), corners.end(), 0);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  setPositions(data, positions);
  data->SetPolys(toTriangles(corners));
  return data;
}

std::int32_t PolyDataBuilder::addPoint(const Vec3& p, const QColor& colour) {
  const Vec3 q = p - m_origin;
  for (int k = 0; k < 3; ++k) m_positions.push_back(static_cast<float>(q[k]));
  for (const int c : {colour.red(), colour.green(), colour.blue(), colour.alpha()}) {
    m_colours.push_back(static_cast<unsigned char>(c));
  }
  return static_cast<std::int32_t>(m_positions.size() / 3 - 1);
}

void PolyDataBuilder::addCell(std::initializer_list<std::int32_t> corners) {
  m_corners.insert(m_corners.end(), corners);
  m_ends.push_back(static_cast<std::int32_t>(m_corners.size()));
}

vtkSmartPointer<vtkPolyData> PolyDataBuilder::build(Kind kind) const {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  setPositions(data, m_positions);
  data->GetPointData()->SetScalars(toArray<vtkUnsignedCharArray>(m_colours, 4));
  const auto cells = toCells(m_ends, m_corners);
  if (kind == Kind::Points) data->SetVerts(cells);
  if (kind == Kind::Segments) data->SetLines(cells);
  if (kind == Kind::Triangles) data->SetPolys(cells);
  return data;
}

}  // namespace handwheel
