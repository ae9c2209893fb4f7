// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "viewport/ViewportTypes.h"

#include <filesystem>

namespace handwheel {

// Renders the mesh with its loops to a PNG of width × height pixels, without a widget and without an application
// object. The camera looks from the front right above, whatever loops there are. Needs an X display with GLX;
// WriteFailed {reason} when there is none or the file cannot be written.
Status renderToFile(const HalfEdgeMesh& mesh, const std::vector<LoopMark>& loops, const std::filesystem::path& png,
                    int width, int height);

}  // namespace handwheel
