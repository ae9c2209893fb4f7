// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

#include <array>
#include <cmath>
#include <optional>

namespace handwheel {

// The branch of a closed-form inverse kinematics solution: shoulder, elbow and wrist. Each has two alternatives.
struct IkBranch {
  bool shoulder = false, elbow = false, wrist = false;
  bool operator==(const IkBranch&) const = default;
};

// The configuration of an arm with a closed form, in descriptive terms.
struct ArmConfiguration {
  enum class Shoulder {
    Front,  // it reaches ahead, the direction it faces with all joints at 0
    Rear,   // it reaches over its back; only with a spherical wrist
    Left,   // its links are left of the line from the first axis to the wrist, seen from above
    Right,  // they are right of it; only with three parallel axes
  };
  Shoulder shoulder = Shoulder::Front;
  bool isElbowUp = true;        // above the line from the second axis to the wrist; up: the z axis of the base
  bool isWristFlipped = false;  // the fifth joint has the lower one of its two values
  bool operator==(const ArmConfiguration&) const = default;
};

// The solutions for a pose.
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

// The closed-form inverse kinematics of an arm with six revolute joints. It supports arms whose axes 2 and 3 are
// parallel and whose axes 4, 5 and 6 meet in a point (a spherical wrist), and arms whose axes 2, 3 and 4 are parallel
// and whose axes 5 and 6 meet, as those of Universal Robots. The steps are the subproblems of Paden and Kahan (Murray,
// Li and Sastry 1994, A Mathematical Introduction to Robotic Manipulation, section 3.3). Immutable; any thread;
// allocates nothing.
class ClosedFormIk {
 public:
  // Returns none if the arm has neither form.
  static std::optional<ClosedFormIk> of(const SerialArm& arm);

  // Finds all solutions for a pose of the tip in the base, joints in -π…π, ignoring limits. A joint that is
  // undetermined, because two axes are in line, keeps the value of the reference. No solutions if the pose is out of
  // reach. O(1).
  void solve(const Pose& tip, const ArmValues& reference, IkSolutions& solutions) const;

  // Returns the configuration of the arm at these values. arm: that of of(). Arbitrary if it is stretched or its elbow
  // is beside the line.
  ArmConfiguration configurationOf(const SerialArm& arm, const ArmValues& values) const;

  // The function A cos q + B sin q.
  struct Wave {
    Wave() = default;
    Wave(double a, double b) : height(std::hypot(a, b)), crest(std::atan2(b, a)) {}
    double height = 0.0, crest = 0.0;  // its maximum, and the angle there; rad
  };

 private:
  enum class Form { SphericalWrist, ParallelMiddle };
  struct Axis {
    Vec3 direction, point;  // in the base, with all joints at 0
  };
  ClosedFormIk() = default;
  void prepare();
  void solveWrist(double q1, double q2, double q3, const Eigen::Matrix3d& turn, const ArmValues& reference,
                  IkBranch branch, IkSolutions& solutions) const;
  void solveMiddle(double q1, const Vec3& position, const Eigen::Matrix3d& turn, const ArmValues& reference,
                   IkBranch branch, IkSolutions& solutions) const;

  Form m_form = Form::SphericalWrist;
  std::array<Axis, 6> m_axes;
  std::array<Vec3, 6> m_across;  // unit vector at a right angle to each axis
  Pose m_fromTip;                // from a pose of the tip to the motion of all joints together
  Vec3 m_centre;                 // intersection of the axes of the wrist; mm
  Vec3 m_wrist;                  // the same in the frame of the fifth joint
  double m_scale = 1.0;          // size of the arm, mm
  // The upper arm, and the forearm up to the centre or the fourth axis, perpendicular to the axes 2 and 3; mm.
  Vec3 m_upper, m_fore;
  Wave m_third, m_fifth;  // effect of the third joint on the squared reach, mm², and of the fifth on the direction of
                          // the sixth axis
};

// Moves values by whole turns into the limits, as near to the reference as these allow. None: a joint cannot be within
// its limits.
std::optional<ArmValues> withinLimits(const SerialArm& arm, const ArmValues& values, const ArmValues& reference);

// Returns the sum of the distances of the joints in space (He 2008, equation 6-14). It selects the nearest of several
// solutions for a pose. from, to: results of SerialArm::jointPoses().
double jointDistance(std::span<const Pose> from, std::span<const Pose> to);

}  // namespace handwheel
