// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/FeelCommand.h"

#include "base/NumberText.h"
#include "cli/FidelityOption.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/TipTrajectory.h"
#include "cli/mesh/FeelSnap.h"
#include "cli/mesh/HapticPathOptions.h"
#include "cli/mesh/RecordingReplay.h"
#include "document/AtomicFile.h"
#include "document/FileBytes.h"
#include "document/mesh/MeshSnapshot.h"
#include "haptics/contact/TouchableSurface.h"
#include "haptics/device/SimulatedDevice.h"
#include "haptics/recording/RecordingCsv.h"
#include "haptics/safety/StiffnessLimit.h"
#include "haptics/scene/TouchFidelity.h"
#include "haptics/snap/SnapFidelity.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshErrors.h"
#include "mesh/structure/Weld.h"

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>

namespace handwheel {

namespace {

// Ten minutes at 8 kHz; the lines of a tick take some 200 bytes.
constexpr std::size_t kMostTicks = 5'000'000;

struct FeelRequest {
  std::filesystem::path mesh, path, out;
  ReadOptions read;
  TouchedSurface surface;
  SnapRequest snap;
  FidelityValues values;
  HapticPathOptions run;
  bool hasDevice = false;
};

// A number of at least `least` behind an option; what is wrong with it, or nothing.
std::string readOption(const Arguments& arguments, std::string_view name, double least, double most, double& value) {
  if (!arguments.has(name)) return {};
  if (readNumber(arguments.valueOf(name), value) && value >= least && value <= most) return {};
  return "--" + std::string(name) + " takes a number from " + roundedText(least) + " to " + roundedText(most) + ".";
}

// Reads the settings of --fidelity, which apply unless another option sets the value. Returns the error as a sentence,
// or nothing.
std::string readSettings(const Arguments& arguments, FeelRequest& request) {
  std::vector<FidelitySetting> read{proxyToleranceSetting(), contactStiffnessSetting(), servoRateSetting()};
  if (request.snap.isOn) read.insert(read.end(), {snapRadiusSetting(), snapFeaturesSetting()});
  const std::string problem = readFidelity(arguments, "feel", read, request.values);
  if (!problem.empty()) return problem;
  request.surface = touchedSurface(ContactSurface(), request.values);
  if (const double rate = servoSettings(request.values).rate; rate > 0.0) request.run.rate = rate;
  return {};
}

// Turns the words into a request. Returns what is wrong with them, or nothing.
std::string readRequest(const Arguments& arguments, FeelRequest& request) {
  request.mesh = arguments.operands[0];
  request.path = arguments.valueOf("path");
  request.out = arguments.valueOf("out");
  request.read.partial = arguments.has("partial");
  if (!arguments.has("path")) return "--path P.csv is missing: the path of the tip.";
  if (arguments.has("out") && (isSameFile(request.out, request.mesh) || isSameFile(request.out, request.path))) {
    return "IN and the path cannot be the output too: " + request.out.string() + ".";
  }
  const std::string device = arguments.valueOf("device");
  request.hasDevice = arguments.has("device");
  if (request.hasDevice && device != "simulated")
    return "--device takes simulated: other devices cannot follow a path.";
  if (const std::string problem = readSnap(arguments, request.snap); !problem.empty()) return problem;
  if (const std::string problem = readSettings(arguments, request); !problem.empty()) return problem;
  TouchedSurface& surface = request.surface;
  for (const std::string& problem : {readOption(arguments, "stiffness", 0.0, 1e6, surface.stiffness),
                                     readOption(arguments, "damping", 0.0, 1e6, surface.damping),
                                     readOption(arguments, "friction", 0.0, 100.0, surface.contact.friction),
                                     readOption(arguments, "snap-stiffness", 0.0, 1e6, request.snap.stiffness),
                                     readOption(arguments, "rate", 1.0, 1e5, request.run.rate)}) {
    if (!problem.empty()) return problem;
  }
  return {};
}

// Applies the limits of the device, with a note if they are lower than the request.
void limitBy(const DeviceCapabilities& device, FeelRequest& request) {
  HapticPathOptions& run = request.run;
  const ServoTiming timing{1.0 / run.rate, device.latency, device.inherentDamping};
  const double stable = stiffnessLimit(timing, 0.0);
  const bool isByTheDevice = device.maxStiffness > 0.0 && device.maxStiffness < stable;
  run.stiffnessLimit = isByTheDevice ? device.maxStiffness : stable;
  run.dampingLimit = device.inherentDamping;
  if (device.maxForce > 0.0) run.maxForce = device.maxForce;
  const double damping = std::min(request.surface.damping, 0.5 * run.dampingLimit);
  const double most = run.stiffnessLimit * (damping > 0.0 ? 1.0 - damping / run.dampingLimit : 1.0);
  if (request.surface.stiffness > most)
    complain("The stiffness is capped at " + roundedText(most, 4) + " N/mm: " +
             (isByTheDevice ? "the limit of the device at any rate."
                            : "more would not be stable on this device at " + roundedText(run.rate) + " Hz."));
  if (damping < request.surface.damping)
    complain("The damping is capped at " + roundedText(damping, 4) + " N·s/mm, half of the device's own.");
}

// The boundary loops of what was read; nothing, and said so, where there are none.
std::optional<SnapAttraction> boundaryAttraction(const FeelRequest& request, const Input& input, Progress progress) {
  if (!request.snap.isOn) return std::nullopt;
  const MeshSnapshot* document = input.meshDocument();
  const HalfEdgeMesh mesh = document ? document->mesh.mesh : buildMesh(input.mesh->soup, progress.part(0.0, 0.6)).mesh;
  const std::vector<BoundaryLoop> loops =
      document ? document->mesh.defects->loops : findBoundaryLoops(mesh, progress.part(0.6, 0.8));
  std::optional<SnapAttraction> feel =
      snapAttraction(request.snap, mesh, loops, request.values, progress.part(0.8, 1.0));
  if (!feel && !progress.cancelled()) complain("The mesh has no open edge to snap to.");
  return feel;
}

// The displayed parts of what is no mesh, in their poses, as the window lets them be felt.
ContactSurface surfaceOf(const DisplayModel& model, Progress progress) {
  std::map<std::shared_ptr<const TriangleSoup>, ContactSurface> shapes;
  std::vector<ContactSurface::Placed> bodies;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const DisplayPart& part = model.parts[i];
    const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(model.parts.size()); };
    const auto [shape, isNew] = shapes.try_emplace(part.soup);
    if (isNew)
      shape->second =
          touchableSurface(part.soup->points, part.soup->triangles, {}, progress.part(share(i), share(i + 1)));
    bodies.push_back({shape->second, part.pose});
  }
  return ContactSurface(std::span<const ContactSurface::Placed>(bodies), nullptr);
}

// The surface as it is read, equal corners of a mesh made one; and what draws the tip.
Result<MeshHaptics> sceneOf(const FeelRequest& request, const DocumentKinds& kinds, std::vector<DocumentFile>& read,
                            Progress progress) {
  const Result<Input> input = readInput(request.mesh, request.read, kinds, progress.part(0.0, 0.3));
  if (!input) return input.error();
  read.push_back(input->opened.file);
  MeshHaptics scene;
  scene.surface = request.surface;
  if (!input->mesh) {
    const DisplayModel model = input->opened.kind->display(*input->opened.content);
    if (model.parts.empty()) return Error{MeshError::NoTriangles, {}, {}, request.mesh.string()};
    if (request.snap.isOn) complain("Only meshes have open edges to snap to.");
    scene.surface->surface = surfaceOf(model, progress.part(0.3, 1.0));
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    return scene;
  }
  const MeshSnapshot* document = input->meshDocument();
  scene.snap = boundaryAttraction(request, *input, progress.part(0.3, 0.5));
  TriangleSoup soup = document ? document->mesh.mesh.compact().soup : weld(input->mesh->soup, progress.part(0.5, 0.6));
  scene.surface->surface =
      touchableSurface(std::move(soup.points), std::move(soup.triangles), {}, progress.part(0.6, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return scene;
}

std::string summary(const HapticPathResult& felt) {
  return "Ticks        " + std::to_string(felt.ticks) + "\nIn contact   " + std::to_string(felt.inContact) +
         "\nPeak force   " + roundedText(felt.peakForce) + " N\nA tick       " +
         roundedText(felt.usualMicroseconds, 3) + " us (median), " + roundedText(felt.slowMicroseconds, 3) +
         " us (99th percentile)\n";
}

}  // namespace

CommandSpec feelSpec() {
  return {
      "feel",
      "IN",
      "Moves a tip along a path over a mesh, or over the bodies of a workpiece, robot cell or volume, and writes the\n"
      "contact forces.\n"
      "A proxy follows the tip and never goes through the surface; the force is F = k (proxy - tip), minus the\n"
      "damping of the speed along the normal. The path is assumed to begin in free space.\n"
      "P.csv has the columns t_s,x_mm,y_mm,z_mm; the tip moves straight between its lines. The output has the columns\n"
      "t_s,hip_x,hip_y,hip_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contact,tick_us, in mm and N.\n"
      "P.csv can also be a recording that the window exported: it is replayed with the settings of the recording, and\n"
      "the mesh is edited at the same ticks. IN is then the mesh as it was opened. Exit code 0: done; 2: not all of\n"
      "the recording could be replayed; 1: error.",
      {
          {"path", 0, "P.csv", "The path of the tip"},
          {"out", 0, "FILE", "Write the state of each tick; - for standard output"},
          {"stiffness", 0, "N/MM", "Stiffness of the surface (default 0.5)"},
          {"damping", 0, "N·S/MM", "Damping of the speed along the normal, in contact (default 0)"},
          {"friction", 0, "MU", "Coulomb friction coefficient (default 0)"},
          {"snap", 0, "PROFILE",
           "none, spring, triangle, quadratic or gaussian: how open edges and their vertices attract the tip "
           "(default none)"},
          {"snap-method", 0, "METHOD", "proxy: one feature at a time; force: the sum of all (default proxy)"},
          {"snap-stiffness", 0, "N/MM", "Stiffness of the snap profile (default 0.3)"},
          {"rate", 0, "HZ", "Ticks per second (default 1000)"},
          {"fidelity", 0, "LIST", "draft, balanced or exact, and single values: proxy.tolerance=1e-6,..."},
          {"device", 0, "NAME", "simulated: stiffness, damping and force limited to those of this device"},
          {"partial", 0, "", "Read the undamaged part of a damaged file"},
          {"help", 'h', "", "Show this help"},
      }};
}

int runFeel(const Arguments& arguments, const DocumentKinds& kinds) {
  FeelRequest request;
  if (const std::string problem = readRequest(arguments, request); !problem.empty()) return failUsage(problem, "feel");
  const Result<std::string> text = readFileBytes(request.path);
  if (!text) {
    Error error = text.error();
    error.subject = request.path.string();
    return fail(error);
  }
  if (isRecordingCsv(*text)) return replayRecording(arguments, *text, kinds);
  TipTrajectory path = readTipTrajectory(*text);
  if (!path.problem.empty()) return refuse(request.path.string() + ": " + path.problem);
  request.run.from = path.poses.front().time;
  request.run.to = path.poses.back().time;
  if (!((request.run.to - request.run.from) * request.run.rate < static_cast<double>(kMostTicks)))
    return refuse(request.path.string() + ": The path takes more than " + std::to_string(kMostTicks) +
                  " ticks. Choose a smaller --rate, or shorten the path.");
  request.run.path = PoseTrajectory(std::move(path.poses));
  if (request.hasDevice) limitBy(simulatedDevice().capabilities, request);

  std::vector<DocumentFile> read;
  std::optional<Error> problem;
  HapticPathResult felt;
  runInterruptible("Feeling", [&](CommandJob& job) {
    Result<MeshHaptics> scene = sceneOf(request, kinds, read, job.progress().part(0.0, 0.5));
    if (!scene) {
      problem = scene.error();
      return;
    }
    felt = feel(request.run, std::move(*scene), job.progress().part(0.5, 1.0));
    if (job.progress().cancelled()) {
      problem = Error{ErrorCode::Cancelled, {}, {}, {}};
      return;
    }
    if (!arguments.has("out") || request.out == "-") return;
    const Status written = writeFileAtomically(request.out, felt.csv, job.progress());
    if (!written) problem = written.error();
  });
  if (problem) return fail(*problem);
  if (felt.cut > 0)
    complain("The force is limited to " + roundedText(request.run.maxForce, 4) + " N, the limit of the device, in " +
             std::to_string(felt.cut) + " of " + std::to_string(felt.ticks) + " ticks: up to " +
             roundedText(felt.askedForce, 4) + " N without this limit.");
  for (DocumentFile& file : read) {
    file.lost.clear();  // nothing is written, so nothing is not kept
    reportLosses(file);
  }
  return print(request.out == "-" ? felt.csv : summary(felt));
}

}  // namespace handwheel
