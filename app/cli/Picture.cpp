// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Picture.h"

#include "cli/ChildProcess.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "document/mesh/MeshSnapshot.h"
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

bool isPictureName(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".png" || ending == ".PNG";
}

CommandSpec pictureSpec() {
  return {"picture",
          "IN PNG",
          "Draws a document; a mesh with its boundary loops. Without a display it does so under xvfb-run.",
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

int runPicture(const Arguments& arguments, const DocumentKinds& kinds) {
  if (!isPictureName(arguments.operands[1])) return failUsage("PNG is a name that ends in .png.", "picture");
  const bool partial = arguments.has("partial");
  if (!hasDisplay()) return makePictureApart(arguments.operands[0], arguments.operands[1], partial);
  std::optional<Result<Input>> input;
  HalfEdgeMesh mesh;
  DisplayModel model;
  runInterruptible("Reading", [&](Job& job) {
    input = readInput(arguments.operands[0], {.partial = partial}, kinds, job.progress());
    if (!*input) return;
    if (const MeshSnapshot* document = input->value().meshDocument()) {
      mesh = document->mesh.mesh;
    } else if (input->value().mesh) {
      mesh = buildMesh(input->value().mesh->soup, job.progress()).mesh;
    } else {
      model = input->value().opened.kind->display(*input->value().opened.content);
    }
  });
  if (!*input) return fail(input->error());
  const std::filesystem::path png = arguments.operands[1];
  endWhenInterrupted();
  const Status drawn = input->value().mesh ? renderToFile(mesh, marksOf(mesh), png, kWidth, kHeight)
                                           : renderToFile(model, png, kWidth, kHeight);
  return drawn ? kExitDone : fail(drawn.error());
}

}  // namespace handwheel
