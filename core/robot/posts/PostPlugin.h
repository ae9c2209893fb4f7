// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/PostProcessor.h"

// Version of the plugin interface, in the plugin's metadata. The version must match exactly, and is compared before any
// code of the plugin is loaded. Increment it with every change of PostProcessor.h, RobotProgram.h, SerialArm.h, Error.h
// or this file.
#define HANDWHEEL_POST_PLUGIN "handwheel.post/9"

namespace handwheel {

// Interface of the root object of a plugin that provides a post. A plugin is never unloaded.
class PostPlugin {
 public:
  virtual ~PostPlugin() = default;
  virtual std::unique_ptr<PostProcessor> post() = 0;
};

}  // namespace handwheel
