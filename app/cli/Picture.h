// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

#include <filesystem>

namespace handwheel {

// Ends in .png or .PNG.
bool isPictureName(const std::filesystem::path& path);

CommandSpec pictureSpec();
int runPicture(const Arguments& arguments, const DocumentKinds& kinds);

// Draws a mesh file in a process of its own, under xvfb-run when there is no display: a broken display ends that
// process only. Says on stderr why there is no picture. Returns an exit code.
int makePictureApart(const std::filesystem::path& mesh, const std::filesystem::path& png, bool partial);

}  // namespace handwheel
