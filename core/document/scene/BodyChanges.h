// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Edit.h"
#include "scene/BodySet.h"

#include <memory>
#include <span>

namespace handwheel {

// Checked edits of the bodies of a document.

inline constexpr std::size_t kLongestBodyName = 200;  // Bytes

// Makes an edit that adds a body with a new number. Errors: NameUnusable {name, most bytes}, NameTaken {name};
// ValueOutOfRange {"the position of the body", value, least, largest}, ElementMalformed {"pose", the fault};
// TooManyBodies {most}, TooManyTriangles {count, most}.
Result<std::unique_ptr<Edit>> addBodyEdit(const BodySet& bodies, Body body);

// Makes an edit that replaces the body with the same number. Returns null if nothing changes. Errors: the errors of
// addBodyEdit(), BodyMissing {number}.
Result<std::unique_ptr<Edit>> changeBodyEdit(const BodySet& bodies, Body body);

// Makes an edit that replaces several bodies, whose names and shapes must not change. Returns null if nothing changes.
// Errors: the errors of changeBodyEdit().
Result<std::unique_ptr<Edit>> changeBodiesEdit(const BodySet& bodies, std::vector<Body> changed);

// Makes an edit that removes bodies. Returns null if there are no bodies with these numbers.
std::unique_ptr<Edit> removeBodiesEdit(const BodySet& bodies, std::span<const BodyId> ids);

// Makes an edit that shows or hides bodies. Returns null if nothing changes.
std::unique_ptr<Edit> showBodiesEdit(const BodySet& bodies, std::span<const BodyId> ids, bool visible);

// Returns true if a text can be the name of a body. It must be UTF-8, one line, neither empty nor too long, with no
// space at either end.
bool isBodyName(std::string_view name);

// Returns the preferred name, with the number if it is 2 or more: "name 2". "body" replaces a preferred name that
// cannot be the name of a body.
std::string numberedBodyName(std::string_view preferred, std::size_t number);

// Returns a name that no body has: the preferred name, or "name 2", "name 3", … if it is taken. "body" replaces a
// preferred name that cannot be the name of a body.
std::string freeBodyName(const BodySet& bodies, std::string_view preferred);

}  // namespace handwheel
