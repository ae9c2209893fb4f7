// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/dh/DhTable.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kDegree = M_PI / 180.0;

// A table in the units of data sheets: mm, degrees, degrees per second, N·m (0: unknown).
struct Published {
  LibraryRobot robot;
  std::array<double, 6> d, a, alpha, theta, sign, lower, upper, speed, torque;
};

constexpr std::array<double, 6> kPlain{1, 1, 1, 1, 1, 1}, kUnknown{};
// Twist angles of arms whose second and third joint bend in a plane through the first axis, with three axes that meet
// in the wrist.
constexpr std::array<double, 6> kSixAxis{-90, 0, -90, 90, -90, 0}, kSixAxisZero{0, -90, 0, 0, 0, 180};
constexpr std::array<double, 6> kStaubli{-90, 0, 90, -90, 90, 0}, kStaubliZero{0, -90, 90, 0, 0, 0};
constexpr std::array<double, 6> kUniversal{90, 0, 0, 90, -90, 0};

constexpr const char* kAbb =
    "All joints at 0: upper arm upright, forearm level. Each joint counts by itself, joint 3 from the upper arm.";
constexpr const char* kKuka =
    "All joints at 0: arm stretched out level. A1, A4 and A6 count against the right-hand rule about the upright and "
    "outward axes; each joint counts by itself, A3 from the upper arm.";
constexpr const char* kUr =
    "All joints at 0: arm stretched out level along -x of the base. Each joint counts by itself.";
constexpr const char* kUpright = "All joints at 0: arm stretched out upright. Each joint counts by itself.";
constexpr const char* kPuma =
    "All joints at 0: upper arm level, forearm upright. Each joint counts by itself, about the z axes of the table.";

// From the manufacturers' documents (ABB 3HAC023604-001, ROB0149EN, 3HAC028284-001; KUKA Spez KR AGILUS sixx; Fanuc
// B-83494EN/03, whose limits of joint 3 hold with joint 2 at 0; Universal Robots CB3; Stäubli D28086504A), and for the
// PUMA 560 from Corke and Armstrong-Hélouvry, A search for consensus among model parameters reported for the PUMA 560
// robot, 1994.
const std::array<Published, 14> kPublished{{
    {{"irb120", "ABB IRB 120-3/0.6", 3.0, kAbb, "ABB 3HAC035960-001; URDF irb120_3_58 of ros-industrial"},
     {290, 0, 0, 302, 0, 72},
     {0, 270, 70, 0, 0, 0},
     kSixAxis,
     kSixAxisZero,
     kPlain,
     {-165, -110, -110, -160, -120, -400},
     {165, 110, 70, 160, 120, 400},
     {250, 250, 250, 320, 320, 420},
     kUnknown},
    {{"irb140", "ABB IRB 140-6/0.8", 6.0, kAbb, "ABB 3HAC041346-001; Denavit-Hartenberg table of ARTE"},
     {352, 0, 0, 380, 0, 65},
     {70, 360, 0, 0, 0, 0},
     kSixAxis,
     kSixAxisZero,
     kPlain,
     {-180, -90, -230, -200, -115, -400},
     {180, 110, 50, 200, 115, 400},
     {200, 200, 260, 360, 360, 450},
     kUnknown},
    {{"irb1600", "ABB IRB 1600-8/1.45", 8.0, kAbb, "ABB 3HAC023604-001; URDF irb1600_8_145 of ros-industrial"},
     {486.5, 0, 0, 600, 0, 65},
     {150, 700, 0, 0, 0, 0},
     kSixAxis,
     kSixAxisZero,
     kPlain,
     {-180, -90, -245, -200, -115, -400},
     {180, 120, 65, 200, 115, 400},
     {180, 180, 200, 400, 400, 460},
     kUnknown},
    {{"irb2400", "ABB IRB 2400-16/1.5", 16.0,
      "All joints at 0: upper arm upright, forearm level. A parallel linkage: the controller counts axis 3 from the "
      "level, joint 3 + joint 2, and its limits (-60 to 65 degrees) are those of the sum.",
      "ABB ROB0149EN; URDF irb2400 and J23_coupled of ros-industrial", AxisCoupling{1.0, -60 * kDegree, 65 * kDegree}},
     {615, 0, 0, 755, 0, 85},
     {100, 705, 135, 0, 0, 0},
     kSixAxis,
     kSixAxisZero,
     kPlain,
     {-180, -100, -170, -200, -120, -400},  // joint 3: what the limits of axes 2 and 3 leave
     {180, 110, 165, 200, 120, 400},
     {150, 150, 150, 360, 360, 450},
     kUnknown},
    {{"irb6640", "ABB IRB 6640-185/2.8", 185.0, kAbb, "ABB 3HAC028284-001; URDF irb6640 of ros-industrial"},
     {780, 0, 0, 1392, 0, 200},
     {320, 1075, 200, 0, 0, 0},
     kSixAxis,
     kSixAxisZero,
     kPlain,
     {-170, -65, -180, -300, -120, -360},
     {170, 85, 70, 300, 120, 360},
     {100, 90, 90, 170, 140, 190},
     kUnknown},
    {{"kr6r900", "KUKA KR 6 R900 sixx", 6.0, kKuka, "KUKA Spez KR AGILUS sixx V12; URDF kr6r900sixx of ros-industrial"},
     {400, 0, 0, 420, 0, 80},
     {25, 455, 35, 0, 0, 0},
     kSixAxis,
     {0, 0, -90, 0, 0, 180},
     {-1, 1, 1, -1, 1, -1},
     {-170, -190, -120, -185, -120, -350},
     {170, 45, 156, 185, 120, 350},
     {360, 300, 360, 381, 388, 615},
     kUnknown},
    {{"kr6r700", "KUKA KR 6 R700 sixx", 6.0, kKuka, "KUKA Spez KR AGILUS sixx V12"},
     {400, 0, 0, 365, 0, 80},
     {25, 315, 35, 0, 0, 0},
     kSixAxis,
     {0, 0, -90, 0, 0, 180},
     {-1, 1, 1, -1, 1, -1},
     {-170, -190, -120, -185, -120, -350},
     {170, 45, 156, 185, 120, 350},
     {360, 300, 360, 381, 388, 615},
     kUnknown},
    {{"lrmate200id", "Fanuc LR Mate 200iD", 7.0,
      "All joints at 0: upper arm upright, forearm level. The controller counts J3 from the level, joint 3 - joint 2, "
      "and its limits are -140.43 to 280 degrees; those of joint 3 itself (-70 to 205) are of the arm. "
      "N: J5 is below 0.",
      "Fanuc B-83494EN/03; URDF lrmate200id of ros-industrial", AxisCoupling{-1.0, -140.43 * kDegree, 280 * kDegree}},
     {330, 0, 0, 335, 0, 80},
     {50, 330, 35, 0, 0, 0},
     kSixAxis,
     {0, -90, 0, 0, 0, 0},
     {1, 1, -1, -1, -1, -1},
     {-170, -100, -70, -190, -125, -360},
     {170, 145, 205, 190, 125, 360},
     {450, 380, 520, 550, 545, 1000},
     kUnknown},
    {{"ur5", "Universal Robots UR5", 5.0, kUr, "Universal Robots, parameters for kinematics and dynamics; manual CB3"},
     {89.159, 0, 0, 109.15, 94.65, 82.3},
     {0, -425, -392.25, 0, 0, 0},
     kUniversal,
     {},
     kPlain,
     {-360, -360, -360, -360, -360, -360},
     {360, 360, 360, 360, 360, 360},
     {180, 180, 180, 180, 180, 180},
     {150, 150, 150, 28, 28, 28}},
    {{"ur10", "Universal Robots UR10", 10.0, kUr,
      "Universal Robots, parameters for kinematics and dynamics; manual CB3"},
     {127.3, 0, 0, 163.941, 115.7, 92.2},
     {0, -612, -572.3, 0, 0, 0},
     kUniversal,
     {},
     kPlain,
     {-360, -360, -360, -360, -360, -360},
     {360, 360, 360, 360, 360, 360},
     {120, 120, 180, 180, 180, 180},
     {330, 330, 150, 56, 56, 56}},
    {{"rx160", "Stäubli RX160", 20.0, kUpright, "Stäubli D28086504A; URDF rx160 of ros-industrial"},
     {550, 0, 0, 625, 0, 110},
     {150, 825, 0, 0, 0, 0},
     kStaubli,
     kStaubliZero,
     kPlain,
     {-160, -137.5, -150, -270, -105, -270},
     {160, 137.5, 150, 270, 120, 270},
     {200, 200, 255, 315, 360, 870},
     {692, 574, 242, 58, 29, 29}},
    {{"tx90", "Stäubli TX90", 6.0, kUpright, "Stäubli data sheet TX90; Denavit-Hartenberg table of ARTE"},
     {478, 50, 0, 425, 0, 100},
     {50, 425, 0, 0, 0, 0},
     kStaubli,
     kStaubliZero,
     kPlain,
     {-180, -130, -145, -270, -115, -270},
     {180, 147.5, 145, 270, 140, 270},
     kUnknown,
     kUnknown},
    {{"tx40", "Stäubli TX40", 1.7, kUpright, "Stäubli data sheet TX40; Denavit-Hartenberg table of ARTE"},
     {320, 35, 0, 225, 0, 65},
     {0, 225, 0, 0, 0, 0},
     kStaubli,
     kStaubliZero,
     kPlain,
     {-180, -125, -138, -270, -120, -270},
     {180, 125, 138, 270, 133.5, 270},
     kUnknown,
     kUnknown},
    {{"puma560", "Unimation PUMA 560", 2.3, kPuma, "Corke and Armstrong-Hélouvry 1994"},
     {671.83, 0, 150.05, 431.8, 0, 0},
     {0, 431.8, 20.3, 0, 0, 0},
     {90, 0, -90, 90, -90, 0},
     {},
     kPlain,
     {-160, -110, -135, -266, -100, -266},
     {160, 110, 135, 266, 100, 266},
     kUnknown,
     kUnknown},
}};

DhTable tableOf(const Published& published) {
  DhTable table;
  table.name = published.robot.title;
  for (std::size_t i = 0; i < 6; ++i) {
    DhJoint joint;
    joint.name = "joint_" + std::to_string(i + 1);
    joint.d = published.d[i];
    joint.a = published.a[i];
    joint.alpha = kDegree * published.alpha[i];
    joint.theta = kDegree * published.theta[i];
    joint.sign = published.sign[i];
    joint.lower = kDegree * published.lower[i];
    joint.upper = kDegree * published.upper[i];
    if (published.speed[i] > 0.0) joint.velocity = kDegree * published.speed[i];
    if (published.torque[i] > 0.0) joint.effort = published.torque[i];
    table.joints.push_back(std::move(joint));
  }
  return table;
}

}  // namespace

std::span<const LibraryRobot> robotLibrary() {
  static const auto kRobots = [] {
    std::vector<LibraryRobot> robots;
    robots.reserve(std::size(kPublished));
    for (const Published& each : kPublished) robots.push_back(each.robot);
    return robots;
  }();
  return kRobots;
}

const LibraryRobot* libraryRobot(std::string_view model) {
  for (const LibraryRobot& robot : robotLibrary()) {
    if (model == robot.title) return &robot;
  }
  return nullptr;
}

const DhTable* libraryTable(std::string_view id) {
  static const auto kTables = [] {
    std::vector<DhTable> tables;
    tables.reserve(std::size(kPublished));
    for (const Published& each : kPublished) tables.push_back(tableOf(each));
    return tables;
  }();
  for (std::size_t i = 0; i < kPublished.size(); ++i) {
    if (id == kPublished[i].robot.id) return &kTables[i];
  }
  return nullptr;
}

}  // namespace handwheel
