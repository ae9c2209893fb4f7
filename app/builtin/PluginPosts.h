// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/PostProcessor.h"

namespace handwheel {

// Loads the plugins in the subfolder "posts" of each plugin folder and returns their postprocessors. Plugins that
// cannot be loaded are reported on stderr. A QCoreApplication must exist.
std::vector<std::unique_ptr<PostProcessor>> pluginPosts();

}  // namespace handwheel
