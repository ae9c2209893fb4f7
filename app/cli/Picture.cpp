// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Picture.h"

#include "cli/ChildProcess.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "document/formats/MeshFormat.h"
#include "mesh/BoundaryLoops.h"
#include "mesh/MeshBuilder.h"
#include "theme/DefectColours.h"
#include "viewport/Snapshot.h"

#include <cstdlib>
#include <optional>

namespace handwheel {

namespace {

constexpr int kWidth = 1280;  // pixels
constexpr int kHeight = 800;

bool hasDisplay() {
  const char* display = std::getenv("DISPLAY");
  return display && *display;
}

std::vector<LoopMark> marksOf(const HalfEdgeMesh& mesh) {
  std::vector<LoopMark> marks;
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) {
    marks.push_back({loop.id, loopPoints(mesh, loop), defectColour(DefectKind::Hole), false});
  }
  return marks;
}

}  // namespace

CommandSpec pictureSpec() {
  return {"picture",
          "IN PNG",
          "Draws a mesh file with its boundary loops. Without a display it does so under xvfb-run.",
          {
              {"partial", 0, "", "Read what is readable of a damaged file"},
              {"help", 'h', "", "Show this page"},
          }};
}

int makePictureApart(const std::filesystem::path& mesh, const std::filesystem::path& png, bool partial) {
  std::vector<std::string> words{ownProgram(), "picture"};
  if (partial) words.push_back("--partial");
  words.insert(words.end(), {"--", mesh.string(), png.string()});
  if (!hasDisplay()) words.insert(words.begin(), {"xvfb-run", "-a"});
  const int code = runChild(words);
  if (wasInterrupted()) return kExitInterrupted;
  if (code == 127) complain("No picture was made: there is no display, and xvfb-run is not installed.");
  if (code > 127) complain("No picture was made: the graphics failed.");
  return code == kExitDone ? kExitDone : kExitError;
}

int runPicture(const Arguments& arguments) {
  const bool partial = arguments.has("partial");
  if (!hasDisplay()) return makePictureApart(arguments.operands[0], arguments.operands[1], partial);
  std::optional<Error> failure;
  HalfEdgeMesh mesh;
  runInterruptible("Reading", [&](Job& job) {
    const ReadOptions options{.partial = partial};
    const Result<MeshFile> file = readMeshFile(arguments.operands[0], options, job.progress());
    if (file) {
      mesh = buildMesh(file->soup).mesh;
    } else {
      failure = file.error();
    }
  });
  if (failure) return fail(*failure);
  const Status drawn = renderToFile(mesh, marksOf(mesh), arguments.operands[1], kWidth, kHeight);
  return drawn ? kExitDone : fail(drawn.error());
}

}  // namespace handwheel
