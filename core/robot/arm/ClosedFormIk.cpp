// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/ClosedFormIk.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr double kSame = 1e-9;  // of lengths to the size of the arm, and of sines

// The vector turned about a unit axis.
Vec3 turned(const Vec3& v, const Vec3& axis, double cosine, double sine) {
  return cosine * v + sine * axis.cross(v) + (1.0 - cosine) * axis.dot(v) * axis;
}

Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
  return turned(v, axis, std::cos(angle), std::sin(angle));
}

Eigen::Matrix3d turnAbout(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

Vec3 across(const Vec3& v, const Vec3& axis) {
  return v - axis.dot(v) * axis;
}

// The angle by which a turns about the axis to point as b does; none where one of them is along the axis. (The first
// subproblem.)
std::optional<double> angleBetween(const Vec3& a, const Vec3& b, const Vec3& axis, double size) {
  const Vec3 u = across(a, axis), v = across(b, axis);
  if (u.norm() < kSame * size || v.norm() < kSame * size) return std::nullopt;
  return std::atan2(axis.dot(u.cross(v)), u.dot(v));
}

// The two angles q with A cos q + B sin q = C. size: what A, B and C are small against.
struct TwoAngles {
  std::array<double, 2> q{};
  int count = 0;
  bool isAny = false;  // every angle solves it
};

TwoAngles solved(double a, double b, double c, double size) {
  const double r = std::hypot(a, b);
  if (r < kSame * size) return {{}, std::abs(c) < kSame * size ? 1 : 0, true};
  if (std::abs(c) > r + kSame * size) return {};
  const double middle = std::atan2(b, a), away = std::acos(std::clamp(c / r, -1.0, 1.0));
  return {{middle + away, middle - away}, 2, false};
}

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * M_PI);
}

// Where two lines meet; none where they do not, or are parallel.
std::optional<Vec3> meeting(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v, double slack) {
  const Vec3 normal = u.cross(v);
  const double square = normal.squaredNorm();
  if (square < 1e-6) return std::nullopt;
  const Vec3 apart = q - p;
  if (std::abs(apart.dot(normal)) > slack * std::sqrt(square)) return std::nullopt;
  return Vec3(p + (apart.cross(v).dot(normal) / square) * u);
}

bool areParallel(const Vec3& u, const Vec3& v) {
  return u.cross(v).norm() < 1e-7;
}

void add(IkSolutions& solutions, const std::array<double, 6>& q, const ArmConfiguration& configuration) {
  IkSolutions::Solution& made = solutions.all[solutions.count++];
  made.values.resize(6);
  for (Eigen::Index i = 0; i < 6; ++i) made.values[i] = wrapped(q[static_cast<std::size_t>(i)]);
  made.configuration = configuration;
}

}  // namespace

std::optional<ClosedFormIk> ClosedFormIk::of(const SerialArm& arm) {
  if (arm.size() != 6) return std::nullopt;
  for (const ArmJoint& joint : arm.joints()) {
    if (joint.isPrismatic) return std::nullopt;
  }
  ClosedFormIk made;
  std::array<Pose, 6> frames;
  const ArmValues zero = ArmValues::Zero(6);
  arm.jointPoses(zero, frames);
  made.m_scale = arm.reach();
  if (!(made.m_scale > 0.0)) return std::nullopt;
  for (std::size_t i = 0; i < 6; ++i) {
    made.m_axes[i] = {frames[i].linear().col(2), frames[i].translation()};
    made.m_across[i] = frames[i].linear().col(0);
  }
  const auto& axes = made.m_axes;
  made.m_fromTip = arm.tipPose(zero).inverse();
  const auto meet = [&](std::size_t a, std::size_t b) {
    return meeting(axes[a].point, axes[a].direction, axes[b].point, axes[b].direction, 1e-7 * made.m_scale);
  };
  const auto isParallel = [&](std::size_t a, std::size_t b) {
    return areParallel(axes[a].direction, axes[b].direction);
  };
  if (!isParallel(1, 2) || isParallel(0, 1)) return std::nullopt;
  const auto centre = meet(4, 5);
  if (!centre) return std::nullopt;
  made.m_centre = *centre;
  const auto wrist = meet(3, 4);
  if (wrist && (*wrist - *centre).norm() < 1e-7 * made.m_scale) {
    made.m_form = Form::SphericalWrist;
    return made;
  }
  if (!isParallel(1, 3)) return std::nullopt;
  made.m_form = Form::ParallelMiddle;
  return made;
}

// In both forms the axes 2 and 3, and in the second 4, are parallel: along them the centre of the wrist is where the
// first joint has put it.
void ClosedFormIk::solve(const Pose& tip, const ArmValues& reference, IkSolutions& solutions) const {
  solutions.count = 0;
  if (!tip.matrix().allFinite()) return;
  const Pose motion = tip * m_fromTip;
  const Vec3 target = motion * m_centre;
  const Vec3 &w1 = m_axes[0].direction, &w2 = m_axes[1].direction, &p1 = m_axes[0].point;
  const Vec3 u = target - p1;
  const double along = w1.dot(u);
  const TwoAngles first =
      solved(w2.dot(across(u, w1)), -w2.dot(w1.cross(u)), w2.dot(m_centre - p1) - along * w1.dot(w2), m_scale);
  for (int i = 0; i < first.count; ++i) {
    const double q1 = first.isAny ? reference[0] : first.q[static_cast<std::size_t>(i)];
    const double c = std::cos(q1), s = std::sin(q1);
    const Vec3 place = p1 + turned(u, w1, c, -s);
    const Eigen::Matrix3d turn = turnAbout(w1, -q1) * motion.linear();
    const ArmConfiguration configuration{i == 1, false, false};
    if (m_form == Form::ParallelMiddle) {
      solveMiddle(q1, place, turn, reference, configuration, solutions);
      continue;
    }
    const Vec3 &w3 = m_axes[2].direction, &p2 = m_axes[1].point, &p3 = m_axes[2].point;
    const Vec3 k = across(p3 - p2, w2), v = across(m_centre - p3, w2), b = across(place - p2, w2);
    const TwoAngles third = solved(k.dot(v), k.dot(w3.cross(v)),
                                   0.5 * (b.squaredNorm() - k.squaredNorm() - v.squaredNorm()), m_scale * m_scale);
    for (int j = 0; j < third.count; ++j) {
      const double q3 = third.isAny ? reference[2] : third.q[static_cast<std::size_t>(j)];
      const double q2 = angleBetween(k + turned(v, w3, q3), b, w2, m_scale).value_or(reference[1]);
      const Eigen::Matrix3d rest = turnAbout(w3, -q3) * turnAbout(w2, -q2) * turn;
      solveWrist(q1, q2, q3, rest, reference, {i == 1, j == 1, false}, solutions);
    }
  }
}

// turn: of the joints 4 to 6 together.
void ClosedFormIk::solveWrist(double q1, double q2, double q3, const Eigen::Matrix3d& turn, const ArmValues& reference,
                              ArmConfiguration configuration, IkSolutions& solutions) const {
  const Vec3 &w4 = m_axes[3].direction, &w5 = m_axes[4].direction, &w6 = m_axes[5].direction;
  const Vec3 pointed = turn * w6;
  const TwoAngles fifth =
      solved(w4.dot(across(w6, w5)), w4.dot(w5.cross(w6)), w4.dot(pointed) - w4.dot(w5) * w5.dot(w6), 1.0);
  for (int k = 0; k < fifth.count; ++k) {
    const double q5 = fifth.isAny ? reference[4] : fifth.q[static_cast<std::size_t>(k)];
    const double q4 = angleBetween(turned(w6, w5, q5), pointed, w4, 1e2).value_or(reference[3]);
    const Vec3 last = turned(turned(turn * m_across[5], w4, -q4), w5, -q5);
    const double q6 = std::atan2(w6.dot(m_across[5].cross(last)), m_across[5].dot(last));
    configuration.wrist = k == 1;
    add(solutions, {q1, q2, q3, q4, q5, q6}, configuration);
  }
}

// place: of the centre, and turn: of the joints 2 to 6 together, the first joint undone.
void ClosedFormIk::solveMiddle(double q1, const Vec3& place, const Eigen::Matrix3d& turn, const ArmValues& reference,
                               ArmConfiguration configuration, IkSolutions& solutions) const {
  const Vec3 &w2 = m_axes[1].direction, &w3 = m_axes[2].direction, &w4 = m_axes[3].direction;
  const Vec3 &w5 = m_axes[4].direction, &w6 = m_axes[5].direction;
  const Vec3 &p2 = m_axes[1].point, &p3 = m_axes[2].point, &p4 = m_axes[3].point;
  const double way3 = w3.dot(w2), way4 = w4.dot(w2);  // 1 or -1
  const TwoAngles fifth =
      solved(w2.dot(across(w6, w5)), w2.dot(w5.cross(w6)), w2.dot(turn * w6) - w2.dot(w5) * w5.dot(w6), 1.0);
  for (int i = 0; i < fifth.count; ++i) {
    const double q5 = fifth.isAny ? reference[4] : fifth.q[static_cast<std::size_t>(i)];
    const Vec3 sideways = turned(w2, w5, -q5);
    const double q6 = angleBetween(turn.transpose() * w2, sideways, w6, 1e2).value_or(reference[5]);
    const Vec3 x = turn * turned(turned(m_across[1], w5, -q5), w6, -q6);  // m_across[1], turned by joints 2 to 4
    const double whole = std::atan2(w2.dot(m_across[1].cross(x)), m_across[1].dot(x));
    const Vec3 elbow = place - turned(m_centre - p4, w2, whole);  // where the fourth axis is to be
    const Vec3 k = across(p3 - p2, w2), v = across(p4 - p3, w2), b = across(elbow - p2, w2);
    const TwoAngles third = solved(k.dot(v), k.dot(w3.cross(v)),
                                   0.5 * (b.squaredNorm() - k.squaredNorm() - v.squaredNorm()), m_scale * m_scale);
    for (int j = 0; j < third.count; ++j) {
      const double q3 = third.isAny ? reference[2] : third.q[static_cast<std::size_t>(j)];
      const double q2 = angleBetween(k + turned(v, w3, q3), b, w2, m_scale).value_or(reference[1]);
      configuration.elbow = j == 1;
      configuration.wrist = i == 1;
      add(solutions, {q1, q2, q3, way4 * (whole - q2 - way3 * q3), q5, q6}, configuration);
    }
  }
}

std::optional<ArmValues> withinLimits(const SerialArm& arm, const ArmValues& values, const ArmValues& reference) {
  constexpr double kTurn = 2.0 * M_PI;
  ArmValues moved = values;
  for (Eigen::Index i = 0; i < arm.size(); ++i) {
    const ArmJoint& joint = arm.joints()[static_cast<std::size_t>(i)];
    if (!joint.isPrismatic) {
      moved[i] += kTurn * std::round((reference[i] - moved[i]) / kTurn);
      if (moved[i] > joint.upper) moved[i] -= kTurn * std::ceil((moved[i] - joint.upper) / kTurn - kSame);
      if (moved[i] < joint.lower) moved[i] += kTurn * std::ceil((joint.lower - moved[i]) / kTurn - kSame);
    }
    if (!joint.isWithin(moved[i])) return std::nullopt;
  }
  return moved;
}

double wayBetween(std::span<const Pose> from, std::span<const Pose> to) {
  assert(from.size() == to.size());
  double way = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) way += (to[i].translation() - from[i].translation()).norm();
  return way;
}

}  // namespace handwheel
