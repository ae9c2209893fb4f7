// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Picture.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/RenderingMemory.h"
#include "cli/SupervisedChild.h"
#include "document/mesh/MeshSnapshot.h"
#include "mesh/structure/MeshBuilder.h"
#include "report/DeviationReport.h"
#include "theme/DefectKind.h"
#include "viewport/OffscreenPicture.h"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace handwheel {

namespace {

constexpr QSize kSize{1280, 800};

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

HalfEdgeMesh meshOf(const Input& input, Progress progress) {
  if (const MeshSnapshot* document = input.meshDocument()) return document->mesh.mesh;
  return buildMesh(input.mesh->soup, progress).mesh;
}

// Reports an error. Without a subject it is about the mesh if memory is exhausted, otherwise about the picture.
int failToDraw(Error error, const PictureRequest& request) {
  if (error.subject.empty())
    error.subject = (error.code == ErrorCode::OutOfMemory ? request.mesh : request.png).string();
  return fail(error);
}

// From here on a signal no longer ends the program: once the picture is written, it is a success.
int save(const QImage& picture, const PictureRequest& request) {
  ignoreSignals();
  const Status saved = savePng(picture, request.png);
  return saved ? kExitDone : failToDraw(saved.error(), request);
}

int drawDocument(const PictureRequest& request, const DocumentKinds& kinds) {
  std::optional<Result<Input>> input;
  HalfEdgeMesh mesh;
  DisplayModel model;
  runInterruptible("Reading", [&](CommandJob& job) {
    input = readInput(request.mesh, {.partial = request.partial}, kinds, job.progress());
    if (!*input) return;
    if (input->value().mesh) {
      mesh = meshOf(input->value(), job.progress());
    } else {
      model = input->value().opened.kind->display(*input->value().opened.content);
    }
  });
  if (!*input) return fail(input->error());
  if (!isEnoughToDraw(mesh.liveFaceCount())) return failForMemory(request.mesh.string());
  endWhenInterrupted();
  Result<QImage> picture =
      input->value().mesh ? renderPicture(mesh, marksOf(mesh), kSize) : renderPicture(model, kSize);
  return picture ? save(*picture, request) : failToDraw(picture.error(), request);
}

// The deviation is measured at the vertices alone, which are coloured.
Result<QImage> deviationSides(const PictureRequest& request, const DocumentKinds& kinds, Progress progress) {
  const ReadOptions read{.partial = request.partial};
  const Result<Input> input = readMeshInput(request.mesh, read, kinds, progress.part(0.0, 0.1));
  if (!input) return input.error();
  const Result<Input> scan = readMeshInput(request.scan, read, kinds, progress.part(0.1, 0.2));
  if (!scan) return scan.error();
  const HalfEdgeMesh mesh = meshOf(*input, progress.part(0.2, 0.25));
  Result<Deviation> found =
      deviation(mesh, meshOf(*scan, progress.part(0.25, 0.3)), {.samples = 0}, progress.part(0.3, 0.9));
  if (!found) return found.error();
  const ColourScale scale{request.range.value_or(defaultRange(found->ofMesh))};
  const auto values = std::make_shared<const std::vector<double>>(std::move(found->ofMesh.atVertex));
  return deviationPicture(mesh, values, scale, progress.part(0.9, 1.0));
}

int drawDeviation(const PictureRequest& request, const DocumentKinds& kinds) {
  std::optional<Result<QImage>> picture;
  runInterruptible("Drawing", [&](CommandJob& job) { picture = deviationSides(request, kinds, job.progress()); });
  if (!*picture) return failToDraw(picture->error(), request);
  endWhenInterrupted();
  return save(picture->value(), request);
}

}  // namespace

bool isPictureName(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".png" || ending == ".PNG";
}

CommandSpec pictureSpec() {
  return {
      "picture",
      "IN PNG",
      "Draws a document; a mesh with its boundary loops, or in the colours of a deviation map. Without a display it\n"
      "does so under xvfb-run.",
      {
          {"scan", 0, "FILE", "Draw a mesh from four sides, coloured by its distance from this one"},
          {"range", 0, "MM", "Distance at the end of the colour scale (default: the 99th percentile)"},
          {"partial", 0, "", "Read the undamaged part of a damaged file"},
          {"help", 'h', "", "Show this help"},
      }};
}

int renderInChildProcess(const PictureRequest& request) {
  std::vector<std::string> words{ownProgram(), "picture"};
  if (request.partial) words.push_back("--partial");
  if (!request.scan.empty()) words.insert(words.end(), {"--scan", request.scan.string()});
  if (request.range) words.insert(words.end(), {"--range", shortestText(*request.range)});
  words.insert(words.end(), {"--", request.mesh.string(), request.png.string()});
  if (!hasDisplay()) words.insert(words.begin(), {"xvfb-run", "-a"});
  const int code = runChild(words);
  if (code != kExitDone && wasInterrupted()) return kExitInterrupted;
  if (code == 127) complain("No picture was made: there is no display, and xvfb-run is not installed.");
  if (code == 128 + SIGKILL) {
    complain("No picture was made: the system ended the rendering process; memory may have run out.");
  } else if (code > 128) {
    complain(std::string("No picture was made: the rendering process ended unexpectedly (") + strsignal(code - 128) +
             "). The graphics failed, or memory ran out.");
  }
  return code == kExitDone ? kExitDone : kExitError;
}

int runPicture(const Arguments& arguments, const DocumentKinds& kinds) {
  PictureRequest request{arguments.operands[0], arguments.operands[1], arguments.has("partial"),
                         arguments.valueOf("scan"), std::nullopt};
  if (!isPictureName(request.png)) return failUsage("PNG is a name that ends in .png.", "picture");
  if (arguments.has("range")) {
    request.range.emplace();
    if (!readNumber(arguments.valueOf("range"), *request.range) || !(*request.range > 0.0)) {
      return failUsage("--range takes a length in mm above zero.", "picture");
    }
  }
  if (!isEnoughToDraw(0)) return failForMemory(request.mesh.string());
  if (!hasDisplay()) return renderInChildProcess(request);
  reportCrashes(request.mesh);
  return request.scan.empty() ? drawDocument(request, kinds) : drawDeviation(request, kinds);
}

}  // namespace handwheel
