// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/dh/DhTable.h"

#include <rapidcheck.h>

#include <QtTest>

// Arms for tests.
namespace handwheel::test {

inline SerialArm libraryArm(std::string_view id) {
  const DhTable* const table = libraryTable(id);
  if (!table) qFatal("there is no such robot");
  return armOf(std::vector<DhRow>(table->joints.begin(), table->joints.end()));
}

inline double evenlyBetween(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

// Returns random values within the limits of the joints, or within ±3 for joints without limits.
inline ArmValues anyValuesOf(const SerialArm& arm) {
  ArmValues values(arm.size());
  for (Eigen::Index i = 0; i < arm.size(); ++i) {
    const ArmJoint& joint = arm.joints()[static_cast<std::size_t>(i)];
    values[i] =
        evenlyBetween(std::isfinite(joint.lower) ? joint.lower : -3.0, std::isfinite(joint.upper) ? joint.upper : 3.0);
  }
  return values;
}

// Returns the difference of two poses: the distance of their origins relative to `size`, or the largest difference of
// the elements of their rotation matrices if that is larger.
inline double difference(const Pose& a, const Pose& b, double size) {
  const double position = (a.translation() - b.translation()).norm() / size;
  return std::max(position, (a.linear() - b.linear()).cwiseAbs().maxCoeff());
}

// Returns a random arm with this number of joints, about axes of every direction. About a quarter of the joints are
// prismatic.
inline SerialArm anyArm(int joints) {
  std::vector<DhRow> table;
  for (int i = 0; i < joints; ++i) {
    DhRow row;
    row.a = evenlyBetween(-300, 300);
    row.d = evenlyBetween(-300, 300);
    row.alpha = evenlyBetween(-3, 3);
    row.theta = evenlyBetween(-3, 3);
    row.sign = *rc::gen::element(1.0, -1.0);
    row.isPrismatic = *rc::gen::inRange(0, 4) == 0;
    row.lower = row.isPrismatic ? -200.0 : -2.5;
    row.upper = row.isPrismatic ? 200.0 : 2.8;
    table.push_back(row);
  }
  return armOf(table);
}

}  // namespace handwheel::test
