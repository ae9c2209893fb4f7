// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/ClosedFormIk.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr double kSame = 1e-9;  // relative to the size of the arm for lengths, and to 1 for sines

// Rotates a vector about a unit axis.
Vec3 turned(const Vec3& v, const Vec3& axis, double cosine, double sine) {
  return cosine * v + sine * axis.cross(v) + (1.0 - cosine) * axis.dot(v) * axis;
}

Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
  return turned(v, axis, std::cos(angle), std::sin(angle));
}

Eigen::Matrix3d turnAbout(const Vec3& axis, double cosine, double sine) {
  Eigen::Matrix3d turn;
  for (int i = 0; i < 3; ++i) turn.col(i) = turned(Vec3::Unit(i), axis, cosine, sine);
  return turn;
}

Vec3 across(const Vec3& v, const Vec3& axis) {
  return v - axis.dot(v) * axis;
}

// An angle with its cosine and sine, which are expensive to compute from it.
struct Angle {
  explicit Angle(double of) : value(of), cosine(std::cos(of)), sine(std::sin(of)) {}
  // The angle of a point of the plane, which is not the origin.
  Angle(double x, double y) : value(std::atan2(y, x)), cosine(x), sine(y) {
    const double length = std::sqrt(x * x + y * y);
    cosine /= length;
    sine /= length;
  }
  double value, cosine, sine;
};

// Returns the angle by which a turns about the axis to point as b does; if one of them is along the axis, `other`. (The
// first subproblem.)
Angle angleBetween(const Vec3& a, const Vec3& b, const Vec3& axis, double size, double other) {
  const Vec3 u = across(a, axis), v = across(b, axis);
  const double least = kSame * kSame * size * size;
  if (u.squaredNorm() < least || v.squaredNorm() < least) return Angle(other);
  return {u.dot(v), axis.dot(u.cross(v))};
}

// The two angles q with A cos q + B sin q = C.
struct TwoAngles {
  std::array<double, 2> q{};
  int count = 0;
  bool isAny = false;  // every angle solves it
};

// size: magnitude relative to which A, B and C count as zero.
TwoAngles solved(const ClosedFormIk::Wave& wave, double c, double size) {
  if (wave.height < kSame * size) return {{}, std::abs(c) < kSame * size ? 1 : 0, true};
  if (std::abs(c) > wave.height + kSame * size) return {};
  const double away = std::acos(std::clamp(c / wave.height, -1.0, 1.0));
  return {{wave.crest + away, wave.crest - away}, 2, false};
}

// Returns remainder(angle, 2π), which is slow, for the sums of few angles.
double wrapped(double angle) {
  constexpr double kTurn = 2.0 * M_PI;
  if (std::abs(angle) <= M_PI) return angle;
  return std::abs(angle) < 3.0 * M_PI ? angle - std::copysign(kTurn, angle) : std::remainder(angle, kTurn);
}

// Returns the intersection of two lines; none if they do not meet, or are parallel.
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

void add(IkSolutions& solutions, const std::array<double, 6>& q, const IkBranch& branch) {
  IkSolutions::Solution& made = solutions.all[solutions.count++];
  made.values.resize(6);
  for (Eigen::Index i = 0; i < 6; ++i) made.values[i] = wrapped(q[static_cast<std::size_t>(i)]);
  made.branch = branch;
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
  made.m_wrist = frames[4].inverse(Eigen::Isometry) * *centre;
  const auto wrist = meet(3, 4);
  if (wrist && (*wrist - *centre).norm() < 1e-7 * made.m_scale) {
    made.m_form = Form::SphericalWrist;
  } else if (isParallel(1, 3)) {
    made.m_form = Form::ParallelMiddle;
  } else {
    return std::nullopt;
  }
  made.prepare();
  return made;
}

// Computes the values that do not depend on the pose.
void ClosedFormIk::prepare() {
  const bool isSpherical = m_form == Form::SphericalWrist;
  const Vec3 &w2 = m_axes[1].direction, &w3 = m_axes[2].direction, &w5 = m_axes[4].direction;
  const Vec3 &w6 = m_axes[5].direction, &p3 = m_axes[2].point;
  m_upper = across(p3 - m_axes[1].point, w2);
  m_fore = across((isSpherical ? m_centre : m_axes[3].point) - p3, w2);
  m_third = Wave(m_upper.dot(m_fore), m_upper.dot(w3.cross(m_fore)));
  const Vec3& above = isSpherical ? m_axes[3].direction : w2;
  m_fifth = Wave(above.dot(across(w6, w5)), above.dot(w5.cross(w6)));
}

// In both forms the axes 2 and 3, and in the second 4, are parallel: the first joint alone moves the centre of the
// wrist along them.
void ClosedFormIk::solve(const Pose& tip, const ArmValues& reference, IkSolutions& solutions) const {
  solutions.count = 0;
  if (!tip.matrix().allFinite()) return;
  const Pose motion = tip * m_fromTip;
  const Vec3 target = motion * m_centre;
  const Vec3 &w1 = m_axes[0].direction, &w2 = m_axes[1].direction, &p1 = m_axes[0].point;
  const Vec3 u = target - p1;
  const double along = w1.dot(u);
  const TwoAngles first =
      solved(Wave(w2.dot(across(u, w1)), -w2.dot(w1.cross(u))), w2.dot(m_centre - p1) - along * w1.dot(w2), m_scale);
  for (int i = 0; i < first.count; ++i) {
    const double q1 = first.isAny ? reference[0] : first.q[static_cast<std::size_t>(i)];
    const double c = std::cos(q1), s = std::sin(q1);
    const Vec3 fourth = p1 + turned(u, w1, c, -s);
    const Eigen::Matrix3d turn = turnAbout(w1, c, -s) * motion.linear();
    const IkBranch branch{i == 1, false, false};
    if (m_form == Form::ParallelMiddle) {
      solveMiddle(q1, fourth, turn, reference, branch, solutions);
      continue;
    }
    const Vec3& w3 = m_axes[2].direction;
    const double sign3 = w3.dot(w2);  // 1 or -1
    const Vec3 b = across(fourth - m_axes[1].point, w2);
    const TwoAngles third =
        solved(m_third, 0.5 * (b.squaredNorm() - m_upper.squaredNorm() - m_fore.squaredNorm()), m_scale * m_scale);
    for (int j = 0; j < third.count; ++j) {
      const double q3 = third.isAny ? reference[2] : third.q[static_cast<std::size_t>(j)];
      const double q2 = angleBetween(m_upper + turned(m_fore, w3, q3), b, w2, m_scale, reference[1]).value;
      const double bent = q2 + sign3 * q3;
      const Eigen::Matrix3d rest = turnAbout(w2, std::cos(bent), -std::sin(bent)) * turn;
      solveWrist(q1, q2, q3, rest, reference, {i == 1, j == 1, false}, solutions);
    }
  }
}

// turn: of the joints 4 to 6 together.
void ClosedFormIk::solveWrist(double q1, double q2, double q3, const Eigen::Matrix3d& turn, const ArmValues& reference,
                              IkBranch branch, IkSolutions& solutions) const {
  const Vec3 &w4 = m_axes[3].direction, &w5 = m_axes[4].direction, &w6 = m_axes[5].direction;
  const Vec3 pointed = turn * w6, across6 = turn * m_across[5];
  const TwoAngles fifth = solved(m_fifth, w4.dot(pointed) - w4.dot(w5) * w5.dot(w6), 1.0);
  for (int k = 0; k < fifth.count; ++k) {
    const Angle q5(fifth.isAny ? reference[4] : fifth.q[static_cast<std::size_t>(k)]);
    const Angle q4 = angleBetween(turned(w6, w5, q5.cosine, q5.sine), pointed, w4, 1e2, reference[3]);
    const Vec3 last = turned(turned(across6, w4, q4.cosine, -q4.sine), w5, q5.cosine, -q5.sine);
    const double q6 = std::atan2(w6.dot(m_across[5].cross(last)), m_across[5].dot(last));
    branch.wrist = k == 1;
    add(solutions, {q1, q2, q3, q4.value, q5.value, q6}, branch);
  }
}

// position: of the centre, and turn: of the joints 2 to 6 together, with the first joint undone.
void ClosedFormIk::solveMiddle(double q1, const Vec3& position, const Eigen::Matrix3d& turn, const ArmValues& reference,
                               IkBranch branch, IkSolutions& solutions) const {
  const Vec3 &w2 = m_axes[1].direction, &w3 = m_axes[2].direction, &w4 = m_axes[3].direction;
  const Vec3 &w5 = m_axes[4].direction, &w6 = m_axes[5].direction;
  const Vec3& p4 = m_axes[3].point;
  const double sign3 = w3.dot(w2), sign4 = w4.dot(w2);  // 1 or -1
  const TwoAngles fifth = solved(m_fifth, w2.dot(turn * w6) - w2.dot(w5) * w5.dot(w6), 1.0);
  for (int i = 0; i < fifth.count; ++i) {
    const Angle q5(fifth.isAny ? reference[4] : fifth.q[static_cast<std::size_t>(i)]);
    const Vec3 sideways = turned(w2, w5, q5.cosine, -q5.sine);
    const Angle q6 = angleBetween(turn.transpose() * w2, sideways, w6, 1e2, reference[5]);
    // m_across[1], turned by the joints 2 to 4.
    const Vec3 x = turn * turned(turned(m_across[1], w5, q5.cosine, -q5.sine), w6, q6.cosine, -q6.sine);
    const double whole = std::atan2(w2.dot(m_across[1].cross(x)), m_across[1].dot(x));
    const Vec3 elbow = position - turned(m_centre - p4, w2, whole);  // required position of the fourth axis
    const Vec3 b = across(elbow - m_axes[1].point, w2);
    const TwoAngles third =
        solved(m_third, 0.5 * (b.squaredNorm() - m_upper.squaredNorm() - m_fore.squaredNorm()), m_scale * m_scale);
    for (int j = 0; j < third.count; ++j) {
      const double q3 = third.isAny ? reference[2] : third.q[static_cast<std::size_t>(j)];
      const double q2 = angleBetween(m_upper + turned(m_fore, w3, q3), b, w2, m_scale, reference[1]).value;
      branch.elbow = j == 1;
      branch.wrist = i == 1;
      add(solutions, {q1, q2, q3, sign4 * (whole - q2 - sign3 * q3), q5.value, q6.value}, branch);
    }
  }
}

ArmConfiguration ClosedFormIk::configurationOf(const SerialArm& arm, const ArmValues& values) const {
  std::array<Pose, 6> poses;
  arm.jointPoses(values, poses);
  const Vec3 up = m_axes[0].direction.z() < 0.0 ? Vec3(-m_axes[0].direction) : m_axes[0].direction;
  const Vec3 &base = m_axes[0].point, &second = m_axes[1].direction;
  const Vec3 axis = poses[1].linear().col(2), wrist = poses[4] * m_wrist;
  const bool isSpherical = m_form == Form::SphericalWrist;
  const Vec3 rest = m_centre - base;
  // The direction that the arm faces, and the side of its links.
  const Vec3 ahead = rest.dot(second.cross(up)) < -kSame * m_scale ? Vec3(up.cross(axis)) : Vec3(axis.cross(up));
  const Vec3 side = rest.dot(second) < 0.0 ? Vec3(-axis) : axis;
  const Vec3 toWrist = across(wrist - base, up);
  ArmConfiguration configuration;
  if (isSpherical)
    configuration.shoulder =
        toWrist.dot(ahead) < 0.0 ? ArmConfiguration::Shoulder::Rear : ArmConfiguration::Shoulder::Front;
  else
    configuration.shoulder =
        toWrist.cross(up).dot(side) < 0.0 ? ArmConfiguration::Shoulder::Left : ArmConfiguration::Shoulder::Right;
  const Vec3 fore = across((isSpherical ? wrist : poses[3].translation()) - poses[1].translation(), axis);
  const Vec3 upper = across(poses[2].translation() - poses[1].translation(), axis);
  const Vec3 bulge = across(upper, fore.stableNormalized());
  configuration.isElbowUp = bulge.dot(up) >= 0.0;
  configuration.isWristFlipped = std::remainder(values[4] - m_fifth.crest, 2.0 * M_PI) < 0.0;
  return configuration;
}

std::optional<double> turnedWithin(const ArmJoint& joint, double value, double reference) {
  constexpr double kTurn = 2.0 * M_PI;
  if (!joint.isPrismatic) {
    value += kTurn * std::round((reference - value) / kTurn);
    if (value > joint.upper) value -= kTurn * std::ceil((value - joint.upper) / kTurn - kSame);
    if (value < joint.lower) value += kTurn * std::ceil((joint.lower - value) / kTurn - kSame);
  }
  return joint.isWithin(value) ? std::optional(value) : std::nullopt;
}

std::optional<ArmValues> withinLimits(const SerialArm& arm, const ArmValues& values, const ArmValues& reference) {
  ArmValues moved = values;
  for (Eigen::Index i = 0; i < arm.size(); ++i) {
    const auto turned = turnedWithin(arm.joints()[static_cast<std::size_t>(i)], values[i], reference[i]);
    if (!turned) return std::nullopt;
    moved[i] = *turned;
  }
  return arm.isWithinLimits(moved) ? std::optional(moved) : std::nullopt;
}

double jointDistance(std::span<const Pose> from, std::span<const Pose> to) {
  assert(from.size() == to.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) distance += (to[i].translation() - from[i].translation()).norm();
  return distance;
}

}  // namespace handwheel
