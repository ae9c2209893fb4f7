// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

#include <array>
#include <cmath>
#include <optional>

namespace handwheel {

// The branch of a closed-form inverse kinematics solution. Shoulder, elbow and wrist have two alternatives each.
struct IkBranch {
  bool shoulder = false, elbow = false, wrist = false;
  bool operator==(const IkBranch&) const = default;
};

// The configuration of an arm with a closed form, in descriptive terms.
struct ArmConfiguration {
  enum class Shoulder {
    Front,  // the arm reaches ahead, in the direction that it faces with all joints at 0
    Rear,   // the arm reaches over its back; only with a spherical wrist
    Left,   // the links are left of the line from the first axis to the wrist, seen from above
    Right,  // the links are right of that line; only with three parallel axes
  };
  Shoulder shoulder = Shoulder::Front;
  bool isElbowUp = true;  // the elbow is above the line from the second axis to the wrist, along the z axis of the base
  bool isWristFlipped = false;  // the fifth joint has the lower of its two values
  bool operator==(const ArmConfiguration&) const = default;
};

// The solutions of the inverse kinematics for a pose.
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
// and whose axes 5 and 6 meet, like the arms of Universal Robots. The steps are the subproblems of Paden and Kahan
// (Murray, Li and Sastry 1994, A Mathematical Introduction to Robotic Manipulation, section 3.3). An object is
// immutable and may be used on any thread; its functions allocate nothing.
class ClosedFormIk {
 public:
  // Returns the closed form of an arm; nothing if the arm has neither of these two forms.
  static std::optional<ClosedFormIk> of(const SerialArm& arm);

  // Finds all solutions for a pose of the tip in the base, with joint values in -π…π, regardless of limits. A joint
  // that is undetermined because two axes are in line keeps the value of the reference. There are no solutions if the
  // pose is out of reach. O(1).
  void solve(const Pose& tip, const ArmValues& reference, IkSolutions& solutions) const;

  // Returns the configuration of the arm at these values. arm: the arm that was passed to of(). The result is arbitrary
  // if the arm is stretched, or if its elbow is level with the line from the second axis to the wrist.
  ArmConfiguration configurationOf(const SerialArm& arm, const ArmValues& values) const;

  // The function A cos q + B sin q.
  struct Wave {
    Wave() = default;
    Wave(double a, double b) : height(std::hypot(a, b)), crest(std::atan2(b, a)) {}
    double height = 0.0, crest = 0.0;  // maximum of the function, and the angle (rad) of the maximum
  };

 private:
  enum class Form { SphericalWrist, ParallelMiddle };
  struct Axis {
    Vec3 direction, point;  // axis in the frame of the base, with all joints at 0
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
  Pose m_fromTip;                // inverse of the pose of the tip with all joints at 0
  Vec3 m_centre;                 // intersection of the axes of the wrist; mm
  Vec3 m_wrist;                  // intersection of these axes, in the frame of the fifth joint; mm
  double m_scale = 1.0;          // size of the arm, mm
  // The upper arm, and the forearm up to the centre of the wrist or to the fourth axis, perpendicular to the axes 2 and
  // 3; mm.
  Vec3 m_upper, m_fore;
  // Effects of the third joint on the squared reach, mm², and of the fifth on the direction of the sixth axis.
  Wave m_third, m_fifth;
};

// Moves the value of a joint by whole turns into its limits, as near to the reference as possible. Returns nothing if
// no turn brings it there.
std::optional<double> turnedWithin(const ArmJoint& joint, double value, double reference);
// Moves joint values by whole turns into the limits, as near to the reference as possible. Returns nothing if a joint
// cannot be brought within its limits, or if the coupled third axis is beyond its own.
std::optional<ArmValues> withinLimits(const SerialArm& arm, const ArmValues& values, const ArmValues& reference);

// Returns the sum of the distances of the joints in space (He 2008, equation 6-14). This distance selects the nearest
// of several solutions for a pose. from, to: joint poses of two solutions, computed by SerialArm::jointPoses().
double jointDistance(std::span<const Pose> from, std::span<const Pose> to);

}  // namespace handwheel
