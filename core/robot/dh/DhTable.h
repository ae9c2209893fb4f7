// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/SrdfReader.h"
#include "robot/arm/SerialArm.h"

namespace handwheel {

// A joint of a robot that a table after Denavit and Hartenberg describes.
struct DhJoint : DhRow {
  std::string name;
  std::optional<double> effort = {};  // N·m, N; none: unknown
  std::string mesh = {};              // file of the link that it moves, in the frame of its row; empty: none
};

// A robot as such a table.
struct DhTable {
  std::string name;
  std::vector<DhJoint> joints;
  std::string baseMesh = {};  // likewise, of what does not move
  double meshUnit = 1.0;      // mm, of the numbers in the meshes
  double thickness = 0.0;     // mm, of links without a mesh; 0: by the size of the robot
};

// The tree of links of a table: "base", a link for each joint ("link_1", …) and, where the last frame is, "flange". The
// frame of a link is where its joint turns it; a mesh stands in the frame of its row. Links without a mesh are drawn as
// plain cylinders between their joints.
RobotModel robotOf(const DhTable& table);

// The pairs of links with a short one between them, whose plain cylinders overlap: their collisions tell nothing. None
// where links have meshes.
std::set<LinkPair> overlappingLinks(const DhTable& table);

// Reads a table from JSON; docs/robots.md has the keys. Limits: kMostArmJoints joints. Errors: ElementMalformed
// {element, reason}, ValueOutOfRange, those of parseJson().
Result<DhTable> readDhTable(std::string_view json);
// Whether a file is such a table, by its first bytes.
bool looksLikeDhTable(std::string_view head);

// The robots that come with the program, by the tables of their manufacturers, as far as these are published.
struct LibraryRobot {
  const char* id;     // "irb120"
  const char* title;  // "ABB IRB 120-3/0.6"
  double payload;     // kg
};
std::span<const LibraryRobot> robotLibrary();
// The one of these that a model is, by its name; null: none.
const LibraryRobot* libraryRobot(std::string_view model);
// Null: there is no such robot.
const DhTable* libraryTable(std::string_view id);

}  // namespace handwheel
