// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "scene/BodyGeometry.h"

namespace handwheel {

// Writes the shape of a body: its arrays to blobs below this folder. Returns its JSON, {"kind", …}.
nlohmann::json writeGeometry(const BodyGeometry& geometry, const std::string& folder, Container& container);

// Reads the shape of a body from its JSON and the blobs below its folder; accepts any input, and never returns null.
// What cannot be read, or is of a kind that this program does not know, becomes an UnknownGeometry, which keeps all of
// it. damage: EntryDamaged {folder}, Unsupported, and the errors of the shapes.
GeometryPointer readGeometry(const nlohmann::json& described, const std::string& folder, const Container& container,
                             std::vector<Error>& damage);

}  // namespace handwheel
