// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/servo/ForceRenderer.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace handwheel {

// Bounds of what a force source exerts in a tick.
struct ForceBounds {
  double stiffness = 0.0;  // N/mm: |dF/dx|
  double damping = 0.0;    // N·s/mm
};

// Base class of objects that exert a force on the tip. Examples are a surface, snap features, a spring, a cutting tool.
// A scene is a list of them (SceneForces). Created on the window thread; then it belongs to the servo thread, where
// nothing may lock, allocate, free or call the system.
//
// A tick has two phases, because only the sum of all sources tells whether the scene is too stiff for the loop: first
// all advance() in the order of the list, then all force() with common shares.
class ForceSource {
 public:
  // id: unique in its scene; a source continues from the source of the same id in the previous scene.
  explicit ForceSource(std::string id) : m_id(std::move(id)) {}
  virtual ~ForceSource() = default;
  ForceSource(const ForceSource&) = delete;
  ForceSource& operator=(const ForceSource&) = delete;

  const std::string& id() const { return m_id; }

  // Continues from its predecessor. Called at most once, before the first tick.
  virtual void follow(const ForceSource& previous) noexcept { (void)previous; }

  // Moves its state to the tip and returns the bounds of the force that force() will return. out: the values that the
  // sources before it in the list have set, such as contact; it may set contact, proxy and held position itself.
  virtual ForceBounds advance(const TipState& tip, ForceOut& out) noexcept = 0;

  // Returns the force of this tick, N, with its stiffness and its damping reduced to these shares (0 to 1).
  virtual Vec3 force(const TipState& tip, double stiffness, double damping) noexcept = 0;

  // Returns the torque of this tick about the tip, N·mm; called after force(). Devices without motors for it get none.
  // The loop limits only its size and rate: the creator of the source is responsible for an angular stiffness that the
  // manufacturer allows.
  virtual Vec3 torque(const TipState& tip) noexcept {
    (void)tip;
    return Vec3::Zero();
  }

  // Returns true if it pulls the tip somewhere. Such a force may change abruptly when the scene does, and is then
  // blended; that of a surface must not be, as the tip would sink in.
  virtual bool isAttraction() const { return false; }

 private:
  const std::string m_id;
};

using ForceSources = std::vector<std::unique_ptr<ForceSource>>;

}  // namespace handwheel
