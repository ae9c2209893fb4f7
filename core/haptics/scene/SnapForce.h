// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/scene/ForceSource.h"
#include "haptics/snap/SnapProxy.h"
#include "haptics/snap/SnapSum.h"

namespace handwheel {

// The methods for computing snap forces: SnapProxy and SnapSum.
enum class SnapMethod { Proxy, Sum };

// Snap features that attract the tip, with force profile and method.
struct SnapAttraction {
  SnapField field;
  SnapProfile profile;
  SnapMethod method = SnapMethod::Proxy;
  std::size_t most = SnapSum::kMost;  // largest number of features that act at once, by the method Sum
};

// The force of snap features. With the method Proxy, facets attract only while no surface is touched. The force
// continues from the feature that its predecessor held.
class SnapForce : public ForceSource {
 public:
  SnapForce(std::string id, SnapAttraction attraction);

  void follow(const ForceSource& previous) noexcept override;
  ForceBounds advance(const TipState& tip, ForceOut& out) noexcept override;
  Vec3 force(const TipState& tip, double stiffness, double damping) noexcept override;
  bool isAttraction() const override { return true; }

  const SnapResult& pull() const { return m_pull; }

 private:
  bool isHeldBy(SnapKind kind) const;

  SnapAttraction m_attraction;
  SnapProxy m_proxy;
  SnapSum m_sum;
  SnapResult m_pull;
};

}  // namespace handwheel
