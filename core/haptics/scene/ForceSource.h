// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/servo/ForceRenderer.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace handwheel {

// Bounds of the force that a source exerts in a tick.
struct ForceBounds {
  double stiffness = 0.0;  // N/mm: bound of |dF/dx|
  double damping = 0.0;    // N·s/mm
};

// Base class of objects that exert a force on the tip. Examples are a surface, snap features, a spring and a cutting
// tool. A scene is a list of sources (SceneForces). A source is created on the window thread. Afterwards it belongs to
// the servo thread, where it must not lock, allocate, free or make system calls.
//
// A tick has two phases, because only the sum of all sources shows whether the scene is too stiff for the loop: first
// advance() of all sources, in the order of the list, and then force() of all sources with the same factors.
class ForceSource {
 public:
  // id: must be unique in its scene. A source continues from the source with the same id in the previous scene.
  explicit ForceSource(std::string id) : m_id(std::move(id)) {}
  virtual ~ForceSource() = default;
  ForceSource(const ForceSource&) = delete;
  ForceSource& operator=(const ForceSource&) = delete;

  const std::string& id() const { return m_id; }

  // Continues from the predecessor of the source. It is called at most once, before the first tick.
  virtual void follow(const ForceSource& previous) noexcept { (void)previous; }

  // Moves the state of the source to the tip, and returns bounds of the force that force() will return. out: the values
  // that the preceding sources in the list have set, such as contact. The source may set contact, proxy and held
  // position.
  virtual ForceBounds advance(const TipState& tip, ForceOut& out) noexcept = 0;

  // Returns the force of this tick, N. stiffness, damping: the factors by which stiffness and damping are reduced, 0 to
  // 1.
  virtual Vec3 force(const TipState& tip, double stiffness, double damping) noexcept = 0;

  // Returns the torque of this tick about the tip, N·mm. It is called after force(), and not used for devices without
  // motors for torque. The loop limits only the size and rate of the torque: the creator of the source is responsible
  // for an angular stiffness that the manufacturer allows.
  virtual Vec3 torque(const TipState& tip) noexcept {
    (void)tip;
    return Vec3::Zero();
  }

  // Returns true if the source pulls the tip to a target. Such a force may change abruptly when the scene changes, and
  // is then blended. The force of a surface must not be blended, because the tip would sink in.
  virtual bool isAttraction() const { return false; }

 private:
  const std::string m_id;
};

using ForceSources = std::vector<std::unique_ptr<ForceSource>>;

}  // namespace handwheel
