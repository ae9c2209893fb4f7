// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/PostArguments.h"

namespace handwheel {

std::string readPost(const Arguments& arguments, ProgramPost& post) {
  if (arguments.has("post")) {
    const std::string side = arguments.valueOf("post");
    if (side != "behind" && side != "front") return "--post is behind or front.";
    post.isInFront = post.isInsertUp = side == "front";
  }
  if (arguments.has("insert")) {
    const std::string side = arguments.valueOf("insert");
    if (side != "up" && side != "down") return "--insert is up or down.";
    post.isInsertUp = side == "up";
  }
  return {};
}

std::vector<OptionSpec> postOptions() {
  return {
      {"post", 0, "SIDE", "Tool post behind the axis (default) or in front of it: behind or front"},
      {"insert", 0, "SIDE",
       "Side that the inserts face: up or down (default: the side that cuts with M3, down behind the axis and up in "
       "front of it)"}};
}

}  // namespace handwheel
