// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

#include <filesystem>
#include <optional>

namespace handwheel {

// Ends in .png or .PNG.
bool isPictureName(const std::filesystem::path& path);

struct PictureRequest {
  std::filesystem::path mesh, png;
  bool partial = false;              // read what is readable
  std::filesystem::path scan = {};   // to colour the mesh by its distance from; empty for none
  std::optional<double> range = {};  // mm, of the colours
};

CommandSpec pictureSpec();
int runPicture(const Arguments& arguments, const DocumentKinds& kinds);

// Draws a mesh file in a process of its own, under xvfb-run when there is no display: a broken display ends that
// process only. Says on stderr why there is no picture. Returns an exit code.
int makePictureApart(const PictureRequest& request);

}  // namespace handwheel
