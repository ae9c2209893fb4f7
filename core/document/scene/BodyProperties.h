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

// Returns the properties of all bodies, "body.NUMBER.FIELD", in groups named after the bodies. Fields: name; x, y, z
// (mm) and rx, ry, rz (rad; scene/RigidPose.h); visible, colour ("#rrggbb"), smooth; the dimensions of a primitive; and
// the read-only fields shape, link and link_state.
std::vector<Property> bodyProperties(const BodySet& bodies);
// Returns the properties of one body.
std::vector<Property> propertiesOf(const Body& body);

// Returns the number of the body in the id of a property; nothing for other properties. The body need not exist.
std::optional<BodyId> bodyOfProperty(std::string_view id);

// Makes an edit that gives a property of a body a new value; null if the property already has this value. Errors:
// ReferenceMissing {"the property", id}, Unsupported for a read-only property, ElementMalformed {id, what was
// expected}, ValueOutOfRange {id, value, least, largest}, NameTaken, NameUnusable.
Result<std::unique_ptr<Edit>> bodyPropertyEdit(const BodySet& bodies, const std::string& id,
                                               const PropertyValue& value);

}  // namespace handwheel
