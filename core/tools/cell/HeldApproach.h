// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/HeldForce.h"
#include "document/cell/CellScene.h"
#include "tools/cell/ApproachSettings.h"

#include <functional>

namespace handwheel {

class RobotCellDocument;

// Services that HeldApproach uses.
struct HeldApproachServices {
  // Returns the present cell prepared for planning, with this robot or, for nothing, the one that is planned for; null
  // while it is being prepared. A null function: nothing is felt.
  std::function<std::shared_ptr<const CellScene>(std::optional<std::size_t> robot)> scene = {};
  double tolerance = DistanceForceSettings().tolerance;  // mm; tolerance of the distances that are felt
  // Settings that all tools which hold objects share; not null.
  std::shared_ptr<ApproachSettings> settings = std::make_shared<ApproachSettings>();
};

// Returns the force on a body that a hand holds in a cell, at these joint values. A body that a link carries does not
// feel that link, nor the other bodies that the link carries. The force is zero if the scene has no shape of the body.
HeldForce forceOnBody(const CellScene& scene, const JointValues& joints, BodyId body,
                      const DistanceForceSettings& settings);
// Returns the force on the robot of a scene that a hand holds by its base, with all bodies that it carries. Obstacles
// that it stands on are ignored.
HeldForce forceOnRobot(const CellScene& scene, const JointValues& joints, const DistanceForceSettings& settings);

// The force on a hand that holds a body or robot near other objects.
class HeldApproach {
 public:
  // The document must outlive this object.
  HeldApproach(const RobotCellDocument& document, HeldApproachServices services);

  ApproachSettings& settings() const { return *m_services.settings; }
  void hold(BodyId body);
  void holdRobot(std::size_t robot);
  void release();

  // Determines the force after a displacement of the held object in the frame of the base. reference: the point about
  // which the torque is measured. The force is zero while the cell is being prepared.
  const HeldForce::Felt& follow(const Pose& displacement, const Vec3& reference);
  // The force that was last determined.
  const HeldForce::Felt& felt() const { return m_felt; }
  // Returns the property of the clearance; nothing if no object is near.
  std::vector<Property> figures() const;

 private:
  struct Held {
    std::optional<BodyId> body = {};        // Nothing: a robot is held
    std::optional<std::size_t> robot = {};  // Nothing: a body is held
    std::optional<HeldForce> force = {};    // Nothing: the cell is not prepared yet
    ApproachSettings settings = {};         // The settings with which the force was made
  };
  void prepare();

  const RobotCellDocument& m_document;
  HeldApproachServices m_services;
  std::optional<Held> m_held;
  HeldForce::Felt m_felt;
};

}  // namespace handwheel
