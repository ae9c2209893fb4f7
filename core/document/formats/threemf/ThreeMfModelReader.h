// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshAssembly.h"
#include "document/formats/threemf/ThreeMfModel.h"

#include <string_view>

namespace handwheel {

// Reads the text of one model part. Damage and lost attributes are recorded in the assembly. A truncated text gives the
// part before its end, if the assembly tolerates the damage. begin: the position of the text among all model parts, in
// bytes; for progress. Returns false if reading must end; the assembly has the reason.
bool readThreeMfModel(std::string_view text, const std::string& partName, std::uint64_t begin, MeshAssembly& assembly,
                      ThreeMfPart& part);

}  // namespace handwheel
