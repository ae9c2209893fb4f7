// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/RevolutionAxis.h"

#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <Eigen/Dense>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

namespace handwheel {

namespace {

constexpr int kGrid = 5;                       // samples along each parameter
constexpr double kSkew = 1e-4;                 // rad: how far a normal may miss the axis
constexpr double kOneAxis = 1e-4;              // mm and rad: axes this near are one
constexpr std::size_t kMostAxes = 30;          // axes that are tried on all faces
constexpr std::size_t kMostCandidates = 1000;  // each is compared with those before it
constexpr std::size_t kMostOfFaces = 600;      // candidates from cylinders, cones and tori
constexpr std::size_t kMostBalls = 10, kMostPlanes = 30;

void sample(ExaminedFace& face) {
  for (int i = 0; i < kGrid; ++i) {
    for (int k = 0; k < kGrid; ++k) {
      const double u = face.u[0] + (i + 0.5) / kGrid * (face.u[1] - face.u[0]);
      const double v = face.v[0] + (k + 0.5) / kGrid * (face.v[1] - face.v[0]);
      gp_Pnt point;
      gp_Vec du, dv;
      face.surface.D1(u, v, point, du, dv);
      const gp_Vec normal = du.Crossed(dv);
      if (normal.Magnitude() > 1e-12 * du.Magnitude() * dv.Magnitude() && normal.Magnitude() > 0.0)
        face.samples.push_back({point, gp_Dir(normal)});
    }
  }
}

struct Candidate {
  gp_Ax1 axis;
  double area;
};

void add(std::vector<Candidate>& all, const gp_Ax1& axis, double area, std::size_t most = kMostCandidates) {
  for (Candidate& known : all) {
    const bool isParallel = known.axis.Direction().IsParallel(axis.Direction(), kOneAxis);
    if (isParallel && gp_Lin(known.axis).Distance(axis.Location()) < kOneAxis) {
      known.area += area;
      return;
    }
  }
  if (all.size() < most) all.push_back({axis, area});
}

// The motion that leaves the samples on their surfaces, if it is a rotation: the null vector of all
// (p × n, n) · (d, c) = 0.
//
// A ball has three of them, and every axis through its middle: those along the coordinates come first.
std::vector<gp_Ax1> axesByNormals(const std::vector<ExaminedFace>& faces) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double size = 0.0, count = 0.0;
  const auto vectorOf = [](const auto& p) { return Eigen::Vector3d(p.X(), p.Y(), p.Z()); };
  for (const ExaminedFace& face : faces)
    for (const auto& s : face.samples) middle += vectorOf(s.point), count += 1.0;
  if (!(count > 0.0)) return {};
  middle /= count;
  for (const ExaminedFace& face : faces)
    for (const auto& s : face.samples) size = std::max(size, (vectorOf(s.point) - middle).norm());
  if (!(size > 0.0)) return {};
  Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
  for (const ExaminedFace& face : faces) {
    for (const auto& s : face.samples) {
      const Eigen::Vector3d p = (vectorOf(s.point) - middle) / size, n = vectorOf(s.normal);
      Eigen::Matrix<double, 6, 1> row;
      row << p.cross(n), n;
      sum += face.area * row * row.transpose();
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(sum);
  const auto axisAt = [&](const Eigen::Vector3d& at, const Eigen::Vector3d& along) {
    const Eigen::Vector3d p = size * at + middle;
    return gp_Ax1(gp_Pnt(p.x(), p.y(), p.z()), gp_Dir(along.x(), along.y(), along.z()));
  };
  std::vector<gp_Ax1> axes;
  const double slack = 1e-9 * solver.eigenvalues()(5);
  if (solver.eigenvalues()(2) < slack) {
    // c = o × d for the three motions, with the middle o of the ball.
    Eigen::Matrix<double, 9, 3> turns;
    Eigen::Matrix<double, 9, 1> moments;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d d = solver.eigenvectors().col(i).head<3>();
      turns.block<3, 3>(3 * i, 0) << 0, d.z(), -d.y(), -d.z(), 0, d.x(), d.y(), -d.x(), 0;
      moments.segment<3>(3 * i) = solver.eigenvectors().col(i).tail<3>();
    }
    const Eigen::Vector3d centre = turns.colPivHouseholderQr().solve(moments);
    for (int k : {2, 0, 1}) axes.push_back(axisAt(centre, Eigen::Vector3d::Unit(k)));
  }
  const Eigen::Matrix<double, 6, 1> motion = solver.eigenvectors().col(0);
  const Eigen::Vector3d d = motion.head<3>(), c = motion.tail<3>();
  if (d.norm() > 0.1) axes.push_back(axisAt(d.cross(c) / d.squaredNorm(), d));
  return axes;
}

// The largest faces, those of one size in their order.
std::vector<const ExaminedFace*> bySize(const std::vector<ExaminedFace>& faces) {
  std::vector<const ExaminedFace*> all;
  for (const ExaminedFace& face : faces) all.push_back(&face);
  std::stable_sort(all.begin(), all.end(), [](const auto* a, const auto* b) { return a->area > b->area; });
  return all;
}

std::vector<const ExaminedFace*> largestOf(const std::vector<const ExaminedFace*>& faces, GeomAbs_SurfaceType type,
                                           std::size_t most) {
  std::vector<const ExaminedFace*> found;
  for (const ExaminedFace* const face : faces)
    if (face->surface.GetType() == type && found.size() < most) found.push_back(face);
  return found;
}

// A ball has every axis through its centre; the normal of a flat face selects one. For a part with hundreds of both,
// such as a casting with its fillets, the largest are sufficient.
void addThroughBalls(const std::vector<const ExaminedFace*>& faces, std::vector<Candidate>& all) {
  const auto planes = largestOf(faces, GeomAbs_Plane, kMostPlanes);
  for (const ExaminedFace* const ball : largestOf(faces, GeomAbs_Sphere, kMostBalls)) {
    const gp_Pnt centre = ball->surface.Sphere().Location();
    for (const ExaminedFace* const flat : planes)
      add(all, {centre, flat->surface.Plane().Axis().Direction()}, ball->area);
    add(all, {centre, gp_Dir(0, 0, 1)}, 0.5 * ball->area);
  }
}

gp_Ax1 inOrder(gp_Ax1 axis) {
  const gp_Dir d = axis.Direction();
  const double most = std::max({std::abs(d.X()), std::abs(d.Y()), std::abs(d.Z())});
  for (const double along : {d.Z(), d.X(), d.Y()}) {
    if (std::abs(along) < most) continue;
    if (along < 0.0) axis.Reverse();
    break;
  }
  const gp_Vec to(gp_Pnt(0, 0, 0), axis.Location());
  const gp_Vec along(axis.Direction());
  const gp_Vec at = to - along * to.Dot(along);
  return {gp_Pnt(at.X(), at.Y(), at.Z()), axis.Direction()};
}

}  // namespace

std::vector<ExaminedFace> examine(const TopoDS_Shape& shape) {
  std::vector<ExaminedFace> faces;
  for (TopExp_Explorer each(shape, TopAbs_FACE); each.More(); each.Next()) {
    ExaminedFace face;
    face.face = TopoDS::Face(each.Current());
    face.surface.Initialize(face.face);
    BRepTools::UVBounds(face.face, face.u[0], face.u[1], face.v[0], face.v[1]);
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face.face, properties);
    face.area = std::abs(properties.Mass());
    sample(face);
    faces.push_back(std::move(face));
  }
  return faces;
}

bool isOfRevolution(const ExaminedFace& face, const gp_Ax1& axis) {
  const gp_Vec along(axis.Direction());
  for (const auto& s : face.samples) {
    const gp_Vec around = along.Crossed(gp_Vec(axis.Location(), s.point));
    if (std::abs(around.Dot(gp_Vec(s.normal))) > kSkew * std::max(around.Magnitude(), 1e-3)) return false;
  }
  return !face.samples.empty();
}

std::optional<gp_Ax1> axisOf(const std::vector<ExaminedFace>& faces) {
  std::vector<Candidate> all;
  const std::vector<const ExaminedFace*> sorted = bySize(faces);
  for (const ExaminedFace* const face : sorted) {
    switch (face->surface.GetType()) {
      case GeomAbs_Cylinder:
        add(all, face->surface.Cylinder().Axis(), face->area, kMostOfFaces);
        break;
      case GeomAbs_Cone:
        add(all, face->surface.Cone().Axis(), face->area, kMostOfFaces);
        break;
      case GeomAbs_Torus:
        add(all, face->surface.Torus().Axis(), face->area, kMostOfFaces);
        break;
      case GeomAbs_SurfaceOfRevolution:
        add(all, face->surface.AxeOfRevolution(), face->area, kMostOfFaces);
        break;
      default:
        break;
    }
  }
  addThroughBalls(sorted, all);
  for (const gp_Ax1& axis : axesByNormals(faces)) add(all, axis, 0.0);
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.area > b.area; });
  if (all.size() > kMostAxes) all.resize(kMostAxes);
  std::optional<gp_Ax1> best;
  double most = 0.0;
  for (const Candidate& candidate : all) {
    double turned = 0.0;
    bool isRound = false;
    for (const ExaminedFace& face : faces) {
      if (!isOfRevolution(face, candidate.axis)) continue;
      turned += face.area;
      isRound = isRound || face.surface.GetType() != GeomAbs_Plane;
    }
    if (isRound && turned > most * (1.0 + 1e-9)) {
      most = turned;
      best = candidate.axis;
    }
  }
  return best ? std::optional<gp_Ax1>(inOrder(*best)) : std::nullopt;
}

}  // namespace handwheel
