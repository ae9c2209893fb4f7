// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Edit.h"
#include "document/Property.h"
#include "scene/BodySet.h"

#include <memory>
#include <optional>
#include <string_view>

namespace handwheel {

// The properties of all bodies, "body.NUMBER.FIELD", in groups named after the bodies. Fields: name; x, y, z (mm) and
// rx, ry, rz (rad; scene/RigidPose.h); visible, colour ("#rrggbb"), smooth; the dimensions of a primitive; and to be
// read only, shape, link and link_state.
std::vector<Property> bodyProperties(const BodySet& bodies);
// Those of one body.
std::vector<Property> propertiesOf(const Body& body);

// The number of the body whose property this would be; none for other properties.
std::optional<BodyId> bodyOfProperty(std::string_view id);

// An edit that gives a property of a body a new value; null when it has that value already. Errors: ReferenceMissing
// {"the property", id}, Unsupported (of one that can only be read), ElementMalformed {id, what was expected},
// ValueOutOfRange {id, value, least, largest}, NameTaken, NameUnusable.
Result<std::unique_ptr<Edit>> bodyPropertyEdit(const BodySet& bodies, const std::string& id,
                                               const PropertyValue& value);

}  // namespace handwheel
