// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

#include <array>
#include <cmath>
#include <optional>

namespace handwheel {

// The branch of a closed-form inverse kinematics solution: shoulder, elbow and wrist. Each is one of two ways.
struct IkBranch {
  bool shoulder = false, elbow = false, wrist = false;
  bool operator==(const IkBranch&) const = default;
};

// How an arm with a closed form stands, as a person sees it.
struct ArmConfiguration {
  enum class Shoulder {
    Front,  // it reaches ahead, as it looks with all joints at 0,
    Rear,   // or over its back: of arms with a spherical wrist
    Left,   // its links are to the left of the way from the first axis to the wrist, seen from above,
    Right,  // or to the right: of arms with three parallel axes
  };
  Shoulder shoulder = Shoulder::Front;
  bool isElbowUp = true;        // above the line from the second axis to the wrist; up: the z axis of the base
  bool isWristFlipped = false;  // of two ways to turn the fifth joint the lower value
  bool operator==(const ArmConfiguration&) const = default;
};

// The ways in which an arm reaches a pose.
struct IkSolutions {
  struct Solution {
    ArmValues values;
    IkBranch branch;
  };
  std::array<Solution, 8> all;
  std::size_t count = 0;

  const Solution* begin() const { return all.data(); }
  const Solution* end() const { return all.data() + count; }
};

// The closed-form inverse kinematics of an arm with six revolute joints. Of arms whose axes 2 and 3 are parallel and
// whose axes 4, 5 and 6 meet in a point (a spherical wrist), and of arms whose axes 2, 3 and 4 are parallel and whose
// axes 5 and 6 meet, as those of Universal Robots. The steps are the subproblems of Paden and Kahan (Murray, Li and
// Sastry 1994, A Mathematical Introduction to Robotic Manipulation, section 3.3). Immutable; any thread; allocates
// nothing.
class ClosedFormIk {
 public:
  // None: the arm is of neither form.
  static std::optional<ClosedFormIk> of(const SerialArm& arm);

  // All solutions for a pose of the tip in the base, joints in -π…π, limits left out. Where a joint may stand anywhere,
  // as two axes are in line, it is that of the reference. None where the pose is out of reach. O(1).
  void solve(const Pose& tip, const ArmValues& reference, IkSolutions& solutions) const;

  // How the arm stands at these values. arm: that of of(). Where it is stretched or its elbow is beside the line, as
  // good as any.
  ArmConfiguration configurationOf(const SerialArm& arm, const ArmValues& values) const;

  // A cos q + B sin q.
  struct Wave {
    Wave() = default;
    Wave(double a, double b) : height(std::hypot(a, b)), crest(std::atan2(b, a)) {}
    double height = 0.0, crest = 0.0;  // its largest value, and for which angle; rad
  };

 private:
  enum class Form { SphericalWrist, ParallelMiddle };
  struct Axis {
    Vec3 direction, point;  // in the base, all joints at 0
  };
  ClosedFormIk() = default;
  void prepare();
  void solveWrist(double q1, double q2, double q3, const Eigen::Matrix3d& turn, const ArmValues& reference,
                  IkBranch branch, IkSolutions& solutions) const;
  void solveMiddle(double q1, const Vec3& place, const Eigen::Matrix3d& turn, const ArmValues& reference,
                   IkBranch branch, IkSolutions& solutions) const;

  Form m_form = Form::SphericalWrist;
  std::array<Axis, 6> m_axes;
  std::array<Vec3, 6> m_across;  // of unit length, at a right angle to each axis
  Pose m_fromTip;                // from a pose of the tip to what the joints must do together
  Vec3 m_centre;                 // where the axes of the wrist meet; mm
  Vec3 m_wrist;                  // the same in the frame of the fifth joint
  double m_scale = 1.0;          // mm, of the arm
  // The upper arm, and the forearm as far as the centre or the fourth axis, across the axes 2 and 3; mm.
  Vec3 m_upper, m_fore;
  Wave m_third, m_fifth;  // what the third joint does to the reach, mm², and the fifth to where the sixth axis points
};

// The values moved by whole turns into the limits, as near to the reference as these let them be. None: a joint cannot
// be within its limits.
std::optional<ArmValues> withinLimits(const SerialArm& arm, const ArmValues& values, const ArmValues& reference);

// Of several ways to the same pose the one in which the joints of the arm are nearest to where they are now: the sum of
// their distances in space (He 2008, equation 6-14). poses: of the joints now, as SerialArm::jointPoses() has them.
double wayBetween(std::span<const Pose> from, std::span<const Pose> to);

}  // namespace handwheel
