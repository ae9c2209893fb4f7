// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/PostProcessor.h"

namespace handwheel {

// A post for a made-up language, as an example of a plugin. The language has the usual statements: joint motions in
// degrees, lines to a position in mm and a quaternion, and zones.
//
//   PROGRAM weld_seam_1
//   JOINT 0.000000 30.000000 ... SPEED 25.00 ZONE 0.000
//   LINE 374.000000 0.000000 630.000000 0.707106781 0.000000000 ... SPEED 100.00 ZONE 5.000
//   END
class ExamplePost : public PostProcessor {
 public:
  const char* id() const override { return "example"; }
  const char* title() const override { return "Example"; }
  const char* ending() const override { return ".moves"; }
  std::string write(const RobotProgram& program) const override;
  Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const override;
};

}  // namespace handwheel
