// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/SectionCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "document/AtomicFile.h"
#include "document/mesh/MeshSnapshot.h"
#include "mesh/measure/SectionDrawing.h"
#include "mesh/structure/MeshBuilder.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

struct SectionRequest {
  std::filesystem::path input, output;
  ReadOptions read;
  Vec3 normal = Vec3::Zero();
  double offset = 0.0;  // mm, along the normal
};

bool readFinite(std::string_view word, double& value) {
  ErrorCode why{};
  return parseDecimal(word, value, why) && std::isfinite(value);
}

bool readNormal(std::string_view words, Vec3& normal) {
  if (words == "x" || words == "y" || words == "z") {
    normal = Vec3::Unit(words[0] - 'x');
    return true;
  }
  for (int k = 0; k < 3; ++k) {
    const std::size_t comma = words.find(',');
    if ((comma == std::string_view::npos) != (k == 2) || !readFinite(words.substr(0, comma), normal[k])) return false;
    if (k < 2) words.remove_prefix(comma + 1);
  }
  const double length = normal.stableNorm();
  if (!(length > 0.0) || !std::isfinite(length)) return false;
  normal /= length;
  return true;
}

// Turns the words into a request. Returns what is wrong with them, or nothing.
std::string readRequest(const Arguments& arguments, SectionRequest& request) {
  request.input = arguments.operands[0];
  request.output = arguments.valueOf("output");
  request.read.partial = arguments.has("partial");
  if (!arguments.has("output")) return "The option -o OUT is missing.";
  if (!arguments.has("plane")) return "The option --plane is missing, for example --plane z=12.5.";
  const std::string plane = arguments.valueOf("plane");
  const std::size_t equals = plane.find('=');
  if (equals == std::string::npos || !readNormal(std::string_view(plane).substr(0, equals), request.normal) ||
      !readFinite(std::string_view(plane).substr(equals + 1), request.offset)) {
    return "--plane takes x=MM, y=MM, z=MM or A,B,C=MM, the plane's normal and its distance from the origin.";
  }
  const std::string ending = request.output.extension().string();
  if (ending != ".svg" && ending != ".dxf") return "-o takes a name that ends in .svg or .dxf.";
  return {};
}

Result<Section> cutFile(const SectionRequest& request, const DocumentKinds& kinds, DocumentFile& losses,
                        Progress progress) {
  const Result<Input> input = readMeshInput(request.input, request.read, kinds, progress.part(0.0, 0.6));
  if (!input) return input.error();
  losses = input->opened.file;
  const MeshSnapshot* document = input->meshDocument();
  const HalfEdgeMesh mesh = document ? document->mesh.mesh : buildMesh(input->mesh->soup, progress.part(0.6, 0.8)).mesh;
  Section section = sectionOf(mesh, request.normal, request.offset, progress.part(0.8, 0.9));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  const bool isSvg = request.output.extension() == ".svg";
  const Status written = writeFileAtomically(
      request.output, isSvg ? svgOf(section, request.normal) : dxfOf(section, request.normal), progress.part(0.9, 1.0));
  if (!written) return written.error();
  return section;
}

std::string readableText(const Section& section) {
  const auto closed = static_cast<std::size_t>(
      std::count_if(section.curves.begin(), section.curves.end(), [](const SectionCurve& c) { return c.closed; }));
  std::string text = "Outlines: " + std::to_string(closed) + " closed, " +
                     std::to_string(section.curves.size() - closed) + " open.\n" +
                     "Length: " + roundedText(section.length) + " mm.\n";
  if (section.isClosed) text += "Area: " + roundedText(section.area) + " mm².\n";
  if (section.facesInPlane > 0 && !section.curves.empty())
    text += "Triangles that lie in the plane: " + std::to_string(section.facesInPlane) +
            ". The section is that just below it, or just above for bodies that begin there.\n";
  return text;
}

// Explains why a section has no curves.
std::string reasonOfNothing(const Section& section) {
  if (section.facesInPlane > 0) return "The surface lies in the plane, so there is no section of it.";
  return section.isTouched ? "The plane only touches the mesh." : "The plane does not intersect the mesh.";
}

}  // namespace

CommandSpec sectionSpec() {
  return {
      "section",
      "FILE",
      "Cuts a mesh by a plane and draws the outlines. The drawing is in mm, at scale 1:1, and seen from the side to\n"
      "which the normal points. Prints the length of the outlines and the enclosed area: parts that overlap count\n"
      "once, cavities not at all. Where a wall lies in the plane the section is that just below it, seen from the\n"
      "side to which the normal points. Exit code 0: done; 2: there is nothing to cut, or an outline is open and has\n"
      "no area; 1: error.",
      {
          {"plane", 0, "PLANE", "x=MM, y=MM, z=MM, or A,B,C=MM: the normal and the distance from the origin"},
          {"output", 'o', "OUT", "The drawing: .svg or .dxf"},
          {"partial", 0, "", "Read the undamaged part of a damaged file"},
          {"help", 'h', "", "Show this help"},
      }};
}

int runSection(const Arguments& arguments, const DocumentKinds& kinds) {
  SectionRequest request;
  const std::string problem = readRequest(arguments, request);
  if (!problem.empty()) return failUsage(problem, "section");
  if (isSameFile(request.input, request.output)) {
    return refuse("FILE cannot be the drawing too: " + request.output.string() + ".");
  }

  DocumentFile losses;
  std::optional<Result<Section>> result;
  runInterruptible("Cutting", [&](CommandJob& job) { result = cutFile(request, kinds, losses, job.progress()); });
  if (!*result) return fail(result->error());
  const Section& section = result->value();
  reportLosses(losses);
  if (const int code = print(readableText(section)); code != kExitDone) return code;
  if (section.curves.empty()) complain(reasonOfNothing(section));
  if (!section.isClosed) complain("An outline is open, so there is no area. 'handwheel repair' closes the mesh.");
  return section.curves.empty() || !section.isClosed ? kExitSomethingLeft : kExitDone;
}

}  // namespace handwheel
