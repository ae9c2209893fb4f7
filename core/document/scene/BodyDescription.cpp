// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyDescription.h"

#include "scene/PrimitiveGeometry.h"

#include <nlohmann/json.hpp>

namespace handwheel {

const char* nameOf(LinkState state) {
  switch (state) {
    case LinkState::Present:
      return "present";
    case LinkState::Missing:
      return "missing";
    case LinkState::Changed:
      return "changed";
    case LinkState::Unchecked:
      break;
  }
  return "unchecked";
}

std::string shapeNameOf(const BodyGeometry& geometry) {
  const auto* primitive = dynamic_cast<const PrimitiveGeometry*>(&geometry);
  return primitive ? primitive->description().id : std::string(geometry.kind());
}

nlohmann::json describeBodies(const BodySet& bodies) {
  nlohmann::json all = nlohmann::json::array();
  for (const BodyPointer& body : bodies) {
    const Vec3 at = body->pose.translation();
    const Eigen::Quaterniond turn(body->pose.linear());
    nlohmann::json link;
    if (body->link) link = {{"path", body->link->path}, {"state", nameOf(body->link->state)}};
    all.push_back({{"id", body->id},
                   {"name", body->name},
                   {"shape", shapeNameOf(*body->geometry)},
                   {"position", {at.x(), at.y(), at.z()}},
                   {"quaternion", {turn.w(), turn.x(), turn.y(), turn.z()}},
                   {"visible", body->visible},
                   {"triangles", body->geometry->surface()->triangles.size()},
                   {"link", link}});
    if (!body->carrier.empty()) all.back()["carrier"] = body->carrier;
  }
  return all;
}

}  // namespace handwheel
