// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/SrdfReader.h"
#include "robot/arm/SerialArm.h"

namespace handwheel {

// A joint of a robot in a Denavit-Hartenberg table.
struct DhJoint : DhRow {
  std::string name;
  std::optional<double> effort = {};  // N·m, N; none: unknown
  std::string mesh = {};              // file of the link that it moves, in the frame of its row; empty: none
};

// A robot as a Denavit-Hartenberg table.
struct DhTable {
  std::string name;
  std::vector<DhJoint> joints;
  std::string baseMesh = {};  // likewise, for the part that does not move
  double meshUnit = 1.0;      // mm per unit of the meshes
  double thickness = 0.0;     // mm, for links without a mesh; 0: by the size of the robot
};

// Returns the link tree of a table: "base", a link for each joint ("link_1", …) and, at the last frame, "flange". The
// frame of a link is at its joint; a mesh is in the frame of its row. Links without a mesh are drawn as plain cylinders
// between their joints.
RobotModel robotOf(const DhTable& table);

// Returns the pairs of links with a short one between them, whose plain cylinders overlap: their collisions mean
// nothing. None if links have meshes.
std::set<LinkPair> overlappingLinks(const DhTable& table);

// Reads a table from JSON; docs/robots.md has the keys. Limits: kMostArmJoints joints. Errors: ElementMalformed
// {element, reason}, ValueOutOfRange, those of parseJson().
Result<DhTable> readDhTable(std::string_view json);
// Returns true if a file is such a table, by its first bytes.
bool looksLikeDhTable(std::string_view head);

// A robot that comes with the program, from the published table of its manufacturer.
struct LibraryRobot {
  const char* id;     // "irb120"
  const char* title;  // "ABB IRB 120-3/0.6"
  double payload;     // kg
};
std::span<const LibraryRobot> robotLibrary();
// Returns the library robot with this model name; null: none.
const LibraryRobot* libraryRobot(std::string_view model);
// Returns null if there is no such robot.
const DhTable* libraryTable(std::string_view id);

}  // namespace handwheel
