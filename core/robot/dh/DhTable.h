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
  std::string mesh = {};  // mesh file of the link that the joint moves, in the frame of the row; empty: none
};

// A robot as a Denavit-Hartenberg table.
struct DhTable {
  std::string name;
  std::vector<DhJoint> joints;
  std::string baseMesh = {};  // mesh file of the link that does not move; empty: none
  double meshUnit = 1.0;      // mm per unit of the meshes
  double thickness = 0.0;     // mm: thickness of links without a mesh; 0: chosen by the size of the robot
};

// Returns the link tree of a table: "base", a link for each joint ("link_1", …) and, at the last frame, "flange". The
// frame of a link is at its joint; a mesh is in the frame of its row. Links without a mesh are drawn as plain cylinders
// between their joints.
RobotModel robotOf(const DhTable& table);
// Returns true for the colours of plain shapes of these links, also after they were written to a file.
bool isTableColour(const ShapeColour& colour);

// Returns the pairs of links whose plain cylinders overlap because only a short link is between them: their collisions
// mean nothing. The result is empty if links have meshes.
std::set<LinkPair> overlappingLinks(const DhTable& table);

// Reads a table from JSON; docs/robots.md describes the keys. There may be at most kMostArmJoints joints. Errors:
// ElementMalformed {element, reason}, ValueOutOfRange, the errors of parseJson().
Result<DhTable> readDhTable(std::string_view json);
// Returns true if the first bytes of a file are those of a Denavit-Hartenberg table in JSON.
bool looksLikeDhTable(std::string_view head);

// A robot that is supplied with the program, according to the published table of its manufacturer.
struct LibraryRobot {
  const char* id;                             // "irb120"
  const char* title;                          // "ABB IRB 120-3/0.6"
  double payload;                             // kg
  const char* conventions = "";               // the zeros, signs and couplings of its joints, in a sentence for reports
  const char* source = "";                    // the documents that lengths, limits and conventions are from
  std::optional<AxisCoupling> coupling = {};  // none: the controller counts each joint by itself
};
std::span<const LibraryRobot> robotLibrary();
// Returns the library robot with this model name; null if there is none.
const LibraryRobot* libraryRobot(std::string_view model);
// Returns the table of the library robot with this id; null if there is no such robot.
const DhTable* libraryTable(std::string_view id);

}  // namespace handwheel
