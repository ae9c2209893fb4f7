// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/NumericalIk.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <chrono>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kLongestTurn = 0.7;  // rad per step: the Jacobian is valid only nearby
constexpr double kLeastDamping = 1e-9;
constexpr double kErrorDamping = 2e-3;  // for each square of the error
constexpr int kMostIterations = 60;     // from one start
constexpr int kMostStalls = 4;          // iterations without progress, after which another start is faster

using Error6 = Eigen::Matrix<double, 6, 1>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostArmJoints, kMostArmJoints>;

// One search: the arm, the wanted pose of its tip, and the present error.
class Search {
 public:
  Search(const SerialArm& arm, const Pose& wanted, const NumericalIkSettings& settings)
      : m_arm(arm), m_wanted(wanted), m_settings(settings) {}

  // Shifts joints into their limits by whole turns if possible, and clamps them otherwise.
  void keepWithin(ArmValues& values) const {
    constexpr double kTurn = 2.0 * M_PI;
    for (Eigen::Index i = 0; i < m_arm.size(); ++i) {
      const ArmJoint& joint = m_arm.joints()[static_cast<std::size_t>(i)];
      double& q = values[i];
      if (!joint.isPrismatic && (q > joint.upper || q < joint.lower)) {
        const double moved = q > joint.upper ? q - kTurn * std::ceil((q - joint.upper) / kTurn)
                                             : q + kTurn * std::ceil((joint.lower - q) / kTurn);
        if (joint.isWithin(moved, 0.0)) q = moved;
      }
      q = std::clamp(q, joint.lower, joint.upper);
      if (!joint.isPrismatic && std::abs(q) > 1e3) q = std::remainder(q, kTurn);  // without limits
    }
  }

  // Returns the error at these values, with lengths relative to the characteristic one; also computes the Jacobian.
  Error6 measure(const ArmValues& values) {
    const Pose tip = m_arm.tipPose(values, m_jacobian);
    Error6 error = poseError(tip, m_wanted);
    error.head<3>() /= m_settings.length;
    m_jacobian.topRows<3>() /= m_settings.length;
    if (m_settings.turnWeight != 1.0) {
      error.tail<3>() *= m_settings.turnWeight;
      m_jacobian.bottomRows<3>() *= m_settings.turnWeight;
    }
    return error;
  }

  // Makes one step from the values of the last measure(). A joint at a limit that the step would leave takes no part in
  // it.
  bool step(const Error6& error, ArmValues& values) const {
    ArmJacobian columns = m_jacobian;
    const Eigen::Index count = m_arm.size();
    for (Eigen::Index i = 0; i < count; ++i) {
      // A slide is measured in characteristic lengths, so that it has the weight of a turn by a radian.
      if (m_arm.joints()[static_cast<std::size_t>(i)].isPrismatic) columns.col(i) *= m_settings.length;
    }
    ArmValues delta(count);
    for (Eigen::Index round = 0; round <= count; ++round) {
      delta = solved(columns, error);
      if (!stopAtLimits(values, delta, columns)) break;
    }
    const double longest = count == 0 ? 0.0 : delta.cwiseAbs().maxCoeff();
    if (!std::isfinite(longest)) return false;
    if (longest > kLongestTurn) delta *= kLongestTurn / longest;
    for (Eigen::Index i = 0; i < count; ++i) {
      const bool isSlide = m_arm.joints()[static_cast<std::size_t>(i)].isPrismatic;
      values[i] += isSlide ? delta[i] * m_settings.length : delta[i];
    }
    return true;
  }

  bool isReached(const Error6& error) const { return error.cwiseAbs().maxCoeff() <= m_settings.tolerance; }

 private:
  // Solves (JᵀJ + λI) δ = Jᵀe, or equivalently δ = Jᵀ(JJᵀ + λI)⁻¹e: the smaller matrix of the two. The matrix of six
  // rows has a fixed size at compile time, which saves a quarter of the time of an iteration.
  static ArmValues solved(const ArmJacobian& columns, const Error6& error) {
    const double damping = kLeastDamping + kErrorDamping * error.squaredNorm();
    const Eigen::Index count = columns.cols();
    if (count < 6) {
      Square square(count, count);
      square.noalias() = columns.transpose() * columns;
      square.diagonal().array() += damping;
      return square.ldlt().solve(columns.transpose() * error);
    }
    Eigen::Matrix<double, 6, 6> square = damping * Eigen::Matrix<double, 6, 6>::Identity();
    for (Eigen::Index i = 0; i < count; ++i) square.noalias() += columns.col(i) * columns.col(i).transpose();
    return columns.transpose() * square.llt().solve(error);
  }

  // Removes the columns of joints at their limits that the step would lead beyond, unless a whole turn less is within.
  bool stopAtLimits(const ArmValues& values, const ArmValues& delta, ArmJacobian& columns) const {
    bool isStopped = false;
    for (Eigen::Index i = 0; i < delta.size(); ++i) {
      const ArmJoint& joint = m_arm.joints()[static_cast<std::size_t>(i)];
      const bool isAtLimit =
          (values[i] >= joint.upper && delta[i] > 0.0) || (values[i] <= joint.lower && delta[i] < 0.0);
      const bool mayTurn = !joint.isPrismatic && joint.upper - joint.lower >= 2.0 * M_PI;
      if (!isAtLimit || mayTurn || columns.col(i).isZero(0.0)) continue;
      columns.col(i).setZero();
      isStopped = true;
    }
    return isStopped;
  }

  const SerialArm& m_arm;
  const Pose& m_wanted;
  const NumericalIkSettings& m_settings;
  ArmJacobian m_jacobian;
};

}  // namespace

void fillWithRandom(const SerialArm& arm, RandomSequence& sequence, ArmValues& values) {
  for (Eigen::Index i = 0; i < arm.size(); ++i) {
    const ArmJoint& joint = arm.joints()[static_cast<std::size_t>(i)];
    const double far = joint.isPrismatic ? arm.reach() : M_PI;
    const double low = std::isfinite(joint.lower) ? joint.lower : std::min(-far, joint.upper - 2.0 * far);
    const double high = std::isfinite(joint.upper) ? joint.upper : std::max(far, low + 2.0 * far);
    values[i] = sequence.between(low, high);
  }
}

Eigen::Matrix<double, 6, 1> poseError(const Pose& at, const Pose& wanted) {
  Error6 error;
  error.head<3>() = wanted.translation() - at.translation();
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(wanted.linear() * at.linear().transpose()));
  error.tail<3>() = turn.angle() * turn.axis();
  return error;
}

NumericalIkResult solvedNumerically(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                    const NumericalIkSettings& settings, Progress progress) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto isLate = [&] { return std::chrono::duration<double>(Clock::now() - begin).count() > settings.seconds; };
  Search search(arm, tip, settings);
  RandomSequence sequence(settings.seed);
  NumericalIkResult result;
  result.values = start;
  search.keepWithin(result.values);
  if (!tip.matrix().allFinite() || !start.allFinite()) return result;
  double least = std::numeric_limits<double>::infinity();
  ArmValues values = result.values;
  while (true) {
    ++result.starts;
    double nearest = std::numeric_limits<double>::infinity();
    int stalls = 0;
    for (int i = 0; i < kMostIterations && stalls < kMostStalls; ++i) {
      const Error6 error = search.measure(values);
      const double size = error.norm();
      ++result.iterations;
      const bool isReached = search.isReached(error);
      result.isSolved = isReached && (!arm.coupling() || arm.coupling()->isWithin(values));
      if (result.isSolved || size < least) {
        least = size;
        result.values = values;
      }
      if (isReached) break;
      stalls = size < 0.99 * nearest ? 0 : stalls + 1;
      nearest = std::min(nearest, size);
      if (!search.step(error, values)) break;
      search.keepWithin(values);
    }
    if (result.isSolved || result.starts >= settings.mostStarts || progress.cancelled() || isLate()) break;
    fillWithRandom(arm, sequence, values);
  }
  const Error6 error = poseError(arm.tipPose(result.values), tip);
  result.distance = error.head<3>().norm();
  result.angle = error.tail<3>().norm();
  return result;
}

// A small weight of the orientation costs tenths of a millimetre of position, which the second search corrects.
NumericalIkResult solvedForPosition(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                    const NumericalIkSettings& settings, Progress progress) {
  constexpr double kLittle = 0.01;
  NumericalIkSettings towards = settings, there = settings;
  towards.turnWeight = kLittle;
  towards.mostStarts = 1;
  there.turnWeight = 0.0;
  const NumericalIkResult near = solvedNumerically(arm, tip, start, towards, progress);
  return solvedNumerically(arm, tip, near.values, there, progress);
}

}  // namespace handwheel
