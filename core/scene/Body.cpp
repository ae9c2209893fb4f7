// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/Body.h"

namespace handwheel {

bool Body::operator==(const Body& other) const {
  return id == other.id && name == other.name && carrier == other.carrier && pose.matrix() == other.pose.matrix() &&
         geometry == other.geometry && look == other.look && visible == other.visible && link == other.link;
}

std::size_t Body::bytes() const {
  std::size_t sum = sizeof *this + name.capacity() + carrier.capacity();
  if (link) sum += link->path.capacity() + link->relative.capacity() + link->sha256.capacity();
  return sum;
}

}  // namespace handwheel
