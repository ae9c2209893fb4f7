// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/PostProcessor.h"

namespace handwheel {

// Returns the posts of the plugins in the folder "posts" of the plugin folders. Plugins that cannot be loaded are
// reported on stderr. Needs a QCoreApplication.
std::vector<std::unique_ptr<PostProcessor>> pluginPosts();

}  // namespace handwheel
