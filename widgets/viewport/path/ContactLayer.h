// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ViewLayer.h"

#include <QColor>
#include <memory>
#include <vector>

namespace handwheel {

// A place where two surfaces touch, with the way out of the one.
struct ContactMark {
  Vec3 place = Vec3::Zero();    // mm
  Vec3 normal = Vec3::UnitZ();  // of unit length
};

// The colour of contacts. It stands out on what has the colour of collisions.
QColor contactColour();

// A view layer with dots where things touch. Lines lead along the normals. Nothing hides them. It is not fitted and not
// picked.
class ContactLayer : public ViewLayer {
 public:
  static constexpr double kNormalLength = 40.0;  // mm

  ContactLayer();
  ~ContactLayer() override;

  void setContacts(std::vector<ContactMark> contacts);

  Box bounds() const override { return {}; }
  Box drawnBounds() const override;
  std::vector<Vec3> outline() const override { return {}; }
  void setStyle(const SurfaceStyle& style) override;
  void prepare(const LayerFrame& frame) override;

 private:
  class Private;
  std::unique_ptr<Private> d;
};

}  // namespace handwheel
