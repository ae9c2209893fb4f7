// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Property.h"
#include "document/cell/RobotCellSnapshot.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Returns true if a description has no collision shapes at all. Its robot then collides with what it shows.
bool collidesWithVisuals(const RobotModel& robot);

// Returns the links and bodies of a cell whose collision shapes could not be read. These are meshes that are missing,
// elements that are no shape, and bodies of unknown kinds. O(shapes + bodies).
std::vector<MissingShape> missingShapes(const CellRobot& robot, const BodySet& bodies, const CellPlans& plans);

// Returns a sentence about such a shape, in English, without a full stop at its end.
std::string sentenceOn(const MissingShape& missing);

// Returns a list for reports, with the keys part, shape, state ("missing", "left out" or "replaced") and by.
nlohmann::json describeMissing(const std::vector<MissingShape>& missing);

// Returns the properties "missing.PART", one for each of these shapes: undecided, left out, or the body that replaces
// it. Empty if no shape is missing.
std::vector<Property> missingProperties(const CellRobot& robot, const BodySet& bodies, const CellPlans& plans);
// Returns the plans after a property of missingProperties() is set. Errors: ElementMalformed {id, reason}.
Result<CellPlans> changedMissing(const std::string& id, const PropertyValue& value, const CellRobot& robot,
                                 const BodySet& bodies, const CellPlans& plans);
// Returns true if the id is that of a property of missingProperties().
bool isMissingProperty(const std::string& id);

}  // namespace handwheel
