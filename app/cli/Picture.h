// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

#include <filesystem>
#include <optional>

namespace handwheel {

// Returns true if the path ends in .png or .PNG.
bool isPictureName(const std::filesystem::path& path);

// A mesh to draw and the file to draw it to.
struct PictureRequest {
  std::filesystem::path mesh, png;
  bool partial = false;              // read the readable part of a damaged file
  std::filesystem::path scan = {};   // reference for colouring the mesh by distance; empty: none
  std::optional<double> range = {};  // range of the colour scale, mm
};

// Syntax of "handwheel picture", which draws a document to a PNG file.
CommandSpec pictureSpec();
int runPicture(const Arguments& arguments, const DocumentKinds& kinds);

// Draws a mesh file in a child process and returns the exit code. Uses xvfb-run if there is no display; a broken
// display ends only the child process. Reports an error on stderr if no picture was made.
int renderInChildProcess(const PictureRequest& request);

}  // namespace handwheel
