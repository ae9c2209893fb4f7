// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/WorkingScale.h"

#include "mesh/structure/MeshBounds.h"

#include <cmath>

namespace handwheel {
namespace {

constexpr int kOrdinary = 150;  // exponents of two of ordinary sizes: up to 1e±45

// Points that are not finite count for nothing.
Box finiteBounds(const HalfEdgeMesh& mesh) {
  Box box;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (const Vec3& p : mesh.points(f)) {
      if (p.allFinite()) box.extend(p);
    }
  }
  return box;
}

}  // namespace

WorkingScale::WorkingScale(const HalfEdgeMesh& mesh) : WorkingScale(finiteBounds(mesh)) {
  // Small parts of a mesh with a few huge coordinates would lose digits, and points would become one.
  for (Vertex v = 0; isNeeded() && v < mesh.vertexSlots(); ++v) {
    const Vec3& p = mesh.position(v);
    if (fromWork(toWork(p)) != p) m_exponent = 0;
  }
}

WorkingScale::WorkingScale(const Box& box) {
  if (box.isEmpty()) return;
  const double size = (0.5 * box.max() - 0.5 * box.min()).maxCoeff();
  if (!(size > 0.0) || !std::isfinite(size)) return;
  int exponent = 0;
  std::frexp(size, &exponent);
  if (std::abs(exponent) > kOrdinary) m_exponent = -exponent;
}

void WorkingScale::apply(HalfEdgeMesh& mesh) {
  m_before.clear();
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
    m_before.push_back(mesh.position(v));
    mesh.setPosition(v, toWork(m_before.back()));
  }
}

void WorkingScale::undo(HalfEdgeMesh& mesh) const {
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
    const Vec3& p = mesh.position(v);
    const bool isUnmoved = v < m_before.size() && p == toWork(m_before[v]);
    mesh.setPosition(v, isUnmoved ? m_before[v] : fromWork(p));
  }
}

double WorkingScale::toWork(double length) const {
  return std::ldexp(length, m_exponent);
}

double WorkingScale::fromWork(double value, int dimension) const {
  return std::ldexp(value, -dimension * m_exponent);
}

Vec3 WorkingScale::toWork(const Vec3& p) const {
  return p.unaryExpr([&](double x) { return std::ldexp(x, m_exponent); });
}

Vec3 WorkingScale::fromWork(const Vec3& p) const {
  return p.unaryExpr([&](double x) { return std::ldexp(x, -m_exponent); });
}

}  // namespace handwheel
