// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#ifdef HANDWHEEL_HAS_KDL

#include "base/RandomSequence.h"
#include "robot/arm/SerialArm.h"

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>

#include <chrono>
#include <optional>

namespace handwheel::bench {

// An arm in KDL, the library of the Orocos project, with its inverse kinematics. The tolerance is in metres and
// radians. An arm is used by one thread at a time.
class KdlArm {
 public:
  enum class Method {
    Newton,              // NR_JL, the usual choice; it continues from its last values until the time is over
    RestartedLevenberg,  // LMA with equal weights; ignores joint limits, and restarts at random until they are met
  };

  KdlArm(const SerialArm& arm, Method method, double tolerance, double seconds)
      : m_arm(arm),
        m_method(method),
        m_seconds(seconds),
        m_low(limitsOf(arm, &ArmJoint::lower)),
        m_high(limitsOf(arm, &ArmJoint::upper)),
        m_chain(chainOf(arm)),
        m_forward(m_chain),
        m_velocity(m_chain),
        m_newton(m_chain, m_low, m_high, m_forward, m_velocity, 1, tolerance),
        m_levenberg(m_chain, Eigen::Matrix<double, 6, 1>::Ones(), tolerance, 60) {}
  KdlArm(const KdlArm&) = delete;
  KdlArm& operator=(const KdlArm&) = delete;

  // Returns joint values for a pose of the tip; nothing if the time is over before. The search starts from the middle
  // of the limits.
  std::optional<ArmValues> solved(const Pose& tip) {
    const auto begin = std::chrono::steady_clock::now();
    const auto isLate = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > m_seconds;
    };
    const KDL::Frame wanted = frameOf(tip);
    KDL::JntArray from(size()), to(size());
    from.data = m_arm.middle();
    RandomSequence random(1);
    do {
      const bool isNewton = m_method == Method::Newton;
      const int code = isNewton ? m_newton.CartToJnt(from, wanted, to) : m_levenberg.CartToJnt(from, wanted, to);
      if (code >= 0) {
        const ArmValues values = isNewton ? ArmValues(to.data) : withoutTurns(to.data);
        if (isNewton || m_arm.isWithinLimits(values)) return values;
      }
      if (isNewton) {
        from = to;
      } else {
        for (unsigned i = 0; i < size(); ++i) from(i) = random.between(m_low(i), m_high(i));
      }
    } while (!isLate());
    return std::nullopt;
  }

 private:
  unsigned size() const { return static_cast<unsigned>(m_arm.size()); }

  static KDL::Frame frameOf(const Pose& pose) {
    const auto& r = pose.linear();
    const Vec3 p = 1e-3 * pose.translation();
    return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
            KDL::Vector(p.x(), p.y(), p.z())};
  }

  // A fixed offset before a joint belongs to the end of the segment before it.
  static KDL::Chain chainOf(const SerialArm& arm) {
    KDL::Chain chain;
    const auto joints = arm.joints();
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), frameOf(joints.front().before)));
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const Pose& after = i + 1 < joints.size() ? joints[i + 1].before : arm.tip();
      chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ), frameOf(after)));
    }
    return chain;
  }

  static KDL::JntArray limitsOf(const SerialArm& arm, double ArmJoint::*limit) {
    KDL::JntArray limits(static_cast<unsigned>(arm.size()));
    for (unsigned i = 0; i < limits.rows(); ++i) limits(i) = arm.joints()[i].*limit;
    return limits;
  }

  static ArmValues withoutTurns(const Eigen::VectorXd& values) {
    return values.unaryExpr([](double each) { return std::remainder(each, 2.0 * M_PI); });
  }

  const SerialArm& m_arm;
  Method m_method;
  double m_seconds;
  KDL::JntArray m_low, m_high;
  KDL::Chain m_chain;
  KDL::ChainFkSolverPos_recursive m_forward;
  KDL::ChainIkSolverVel_pinv m_velocity;
  KDL::ChainIkSolverPos_NR_JL m_newton;
  KDL::ChainIkSolverPos_LMA m_levenberg;
};

}  // namespace handwheel::bench

#endif
