// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/problems/PlanningSet.h"
#include "robot/Kinematics.h"
#include "robot/SrdfReader.h"
#include "robot/UrdfReader.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace handwheel::bench {

// The UR5 robot as spheres, with the problems of MotionBenchMaker. The files are read from the folder HANDWHEEL_DATA.
// The check of paths shares no code with the planners, except the reading of the files, the forward kinematics and the
// pairs of links that may touch.
class SphereRobot {
 public:
  static std::optional<SphereRobot> read() {
    const char* const data = std::getenv("HANDWHEEL_DATA");
    if (!data) return std::nullopt;
    const std::filesystem::path folder = std::filesystem::path(data) / "planning" / "motionbenchmaker-ur5";
    const Result<ImportedRobot> urdf = readUrdf(textOf(folder / "robot" / "ur5_spherized.urdf"));
    if (!urdf) return std::nullopt;
    const Result<RobotSemantics> semantics = readSrdf(textOf(folder / "robot" / "ur5.srdf"), urdf->robot);
    SphereRobot made(urdf->robot);
    made.m_allowed = neighbours(made.m_model);
    if (semantics) made.m_allowed.insert(semantics->allowed.begin(), semantics->allowed.end());
    for (const char* scene :
         {"bookshelf_small", "bookshelf_tall", "bookshelf_thin", "box", "cage", "table_pick", "table_under_pick"}) {
      const Result<PlanningSet> set = readPlanningSet(textOf(folder / (std::string(scene) + "_ur5.json")));
      if (!set) return std::nullopt;
      made.m_sets.push_back(*set);
    }
    for (const std::string& joint : made.m_sets.front().joints) {
      for (std::uint32_t dof = 0; dof < made.m_model.dofs.size(); ++dof) {
        if (made.m_model.jointOfDof(dof).name == joint) made.m_dofs.push_back(dof);
      }
    }
    const std::set<LinkPair> always = made.bare().alwaysMeeting();
    made.m_allowed.insert(always.begin(), always.end());
    return made;
  }

  const std::vector<PlanningSet>& sets() const { return m_sets; }

  RobotScene sceneOf(const PlanningProblem& problem) const {
    RobotScene scene = bare();
    for (std::size_t i = 0; i < problem.obstacles.size(); ++i)
      scene.addObstacle(CollisionBody({problem.obstacles[i]}), Pose::Identity(), static_cast<std::uint32_t>(i));
    return scene;
  }

  // Returns true if the robot collides at one of the configurations along a path, sampled at this step.
  bool isColliding(const PlanningProblem& problem, const std::vector<ArmValues>& path, double step) const {
    for (std::size_t i = 1; i < path.size(); ++i) {
      const ArmValues motion = path[i] - path[i - 1];
      const int parts = std::max(1, static_cast<int>(std::ceil(motion.cwiseAbs().maxCoeff() / step)));
      for (int k = 0; k <= parts; ++k) {
        if (isColliding(problem, ArmValues(path[i - 1] + (static_cast<double>(k) / parts) * motion))) return true;
      }
    }
    return false;
  }

 private:
  struct Ball {
    std::uint32_t link;
    Vec3 centre;  // position in the frame of the link, mm
    double radius;
  };

  explicit SphereRobot(const RobotModel& model) : m_model(model), m_rest(restValues(model)) {
    for (std::uint32_t l = 0; l < model.links.size(); ++l) {
      for (const PlacedShape& placed : model.links[l].collisions)
        m_balls.push_back({l, placed.origin.translation(), std::get<SphereShape>(model.shapes[placed.shape]).radius});
    }
  }

  static std::string textOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  RobotScene bare() const {
    return RobotScene(m_model, Pose::Identity(), collisionBodies(m_model), m_dofs, m_rest, m_allowed);
  }

  // Returns the distance of a point from the surface of a box, cylinder or sphere; 0 or less: inside.
  static double distance(const CollisionPiece& piece, const Vec3& point) {
    const Vec3 p = piece.pose.inverse() * point;
    switch (piece.kind) {
      case CollisionPiece::Kind::Block:
        return (p.cwiseAbs() - piece.half).cwiseMax(0.0).norm();
      case CollisionPiece::Kind::Cylinder:
        return std::hypot(std::max(0.0, p.head<2>().norm() - piece.half.x()),
                          std::max(0.0, std::abs(p.z()) - piece.half.z()));
      default:
        return p.norm() - piece.half.x();
    }
  }

  bool isColliding(const PlanningProblem& problem, const ArmValues& values) const {
    JointValues joints = m_rest;
    for (std::size_t i = 0; i < m_dofs.size(); ++i) joints[m_dofs[i]] = values[static_cast<Eigen::Index>(i)];
    const std::vector<Pose> poses = linkPoses(m_model, joints);
    std::vector<Vec3> centres;
    for (const Ball& ball : m_balls) centres.push_back(poses[ball.link] * ball.centre);
    for (std::size_t i = 0; i < m_balls.size(); ++i) {
      if (isMoved(m_balls[i].link)) {
        for (const CollisionPiece& piece : problem.obstacles) {
          if (distance(piece, centres[i]) <= m_balls[i].radius) return true;
        }
      }
      for (std::size_t k = 0; k < i; ++k) {
        const LinkPair pair = std::minmax(m_balls[i].link, m_balls[k].link);
        if (pair.first == pair.second || m_allowed.contains(pair)) continue;
        if (!isMoved(pair.first) && !isMoved(pair.second)) continue;
        const double least = m_balls[i].radius + m_balls[k].radius;
        if ((centres[i] - centres[k]).squaredNorm() <= least * least) return true;
      }
    }
    return false;
  }

  // Returns true if a movable joint is between the link and the root.
  bool isMoved(std::uint32_t link) const {
    for (std::uint32_t j = m_model.links[link].parentJoint; j != kNone;
         j = m_model.links[m_model.joints[j].parent].parentJoint) {
      if (m_model.joints[j].dof != kNone && m_model.joints[j].kind != JointKind::Fixed) return true;
    }
    return false;
  }

  RobotModel m_model;
  JointValues m_rest;
  std::vector<std::uint32_t> m_dofs;
  std::set<LinkPair> m_allowed;
  std::vector<PlanningSet> m_sets;
  std::vector<Ball> m_balls;
};

}  // namespace handwheel::bench
