// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RecordingReplay.h"

#include "base/NumberText.h"
#include "base/ThreadClock.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/mesh/EditCommand.h"
#include "cli/mesh/HapticPathOptions.h"
#include "cli/mesh/RecordedScenes.h"
#include "document/AtomicFile.h"
#include "haptics/recording/RecordingCsv.h"
#include "mesh/structure/CancelPolling.h"

namespace handwheel {

namespace {

struct FeltAgain {
  HapticPathResult felt;
  std::size_t same = 0;     // ticks with the recorded force, to the last digit
  double difference = 0.0;  // N, the largest
  std::size_t without = 0;  // ticks of which no scene, or no contact, is known
  std::size_t scenes = 0, edits = 0;
  std::set<std::string> leftOut;
  std::string problem;
};

Result<FeltAgain> felt(const Recording& recording, RecordedScenes& scenes, const Progress& progress) {
  HapticPathTable table;
  FeltAgain again;
  std::size_t i = 0;
  const auto sceneAt = [&](const RecordedTick& tick) -> ForceRenderer* {
    if (!pollProgress(i++, recording.size(), progress, 1024)) return nullptr;
    ForceRenderer* const scene = progress.cancelled() ? nullptr : scenes.at(tick);
    again.without += tick.hasSource && !scene ? 1 : 0;
    return scene;
  };
  std::uint64_t start = threadCpuNanoseconds();
  recording.replay(sceneAt, [&](const RecordedTick& tick, const ForceOut& out) {
    const std::uint64_t end = threadCpuNanoseconds();
    table.add(tick.tip, out, 1e-3 * static_cast<double>(end - start), out.force.norm());
    again.same += out.force == tick.felt.force ? 1 : 0;
    const double difference = (out.force - tick.felt.force).norm();
    if (difference > again.difference) again.difference = difference;
    start = threadCpuNanoseconds();
  });
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  again.felt = table.take();
  again.scenes = scenes.sceneCount();
  again.edits = scenes.editCount();
  again.leftOut = scenes.leftOut();
  again.problem = scenes.problem();
  return again;
}

Result<FeltAgain> felt(const Arguments& arguments, std::string_view text, const DocumentKinds& kinds,
                       Progress progress) {
  Result<Recording> recording = recordingFromCsv(text, progress.part(0.0, 0.2));
  if (!recording) {
    Error error = recording.error();
    error.subject = arguments.valueOf("path");
    return error;
  }
  const MeshFileReader readMesh = meshFileReader(kinds);
  Result<OpenedFile> opened =
      kinds.open(arguments.operands[0], {.partial = arguments.has("partial")}, progress.part(0.2, 0.4));
  if (!opened) return opened.error();
  const Progress feeling = progress.part(0.4, 1.0);
  if (!dynamic_cast<const MeshSnapshot*>(opened->content.get())) {
    RecordedScenes scenes(*recording, opened->kind->display(*opened->content), feeling);
    return felt(*recording, scenes, feeling);
  }
  MeshDocument document(*std::move(opened));
  RecordedScenes scenes(*recording, document, readMesh, feeling);
  return felt(*recording, scenes, feeling);
}

std::string summary(const FeltAgain& again) {
  const HapticPathResult& felt = again.felt;
  return "Ticks        " + std::to_string(felt.ticks) + "\nScenes       " + std::to_string(again.scenes) + ", edits " +
         std::to_string(again.edits) + "\nIn contact   " + std::to_string(felt.inContact) + "\nPeak force   " +
         roundedText(felt.peakForce) + " N\nAs recorded  " + std::to_string(again.same) +
         " ticks bit for bit; the largest difference is " + roundedText(again.difference) + " N\n";
}

}  // namespace

int replayRecording(const Arguments& arguments, std::string_view text, const DocumentKinds& kinds) {
  for (const char* option :
       {"stiffness", "damping", "friction", "snap", "snap-method", "snap-stiffness", "rate", "fidelity", "device"}) {
    if (arguments.has(option))
      return failUsage("--path is a recording, which has its own --" + std::string(option) + ": leave it out.", "feel");
  }
  std::optional<Result<FeltAgain>> result;
  Status written = Done{};
  const std::string out = arguments.valueOf("out");
  runInterruptible("Feeling", [&](CommandJob& job) {
    result = felt(arguments, text, kinds, job.progress());
    if (*result && !out.empty() && out != "-") written = writeFileAtomically(out, result->value().felt.csv, {});
  });
  if (!*result) return fail(result->error());
  if (!written) return fail(written.error());
  const FeltAgain& again = result->value();
  for (const std::string& id : again.leftOut)
    complain("The force '" + id + "' of the recording is left out: only surfaces are replayed.");
  if (!again.problem.empty()) complain("The recording is replayed only up to a change: " + again.problem);
  if (again.without > 0)
    complain(std::to_string(again.without) +
             " ticks are left out: their scene, or a contact that began in it, is not known.");
  const int code = print(out == "-" ? again.felt.csv : summary(again));
  if (code != kExitDone) return code;
  return again.problem.empty() && again.without == 0 ? kExitDone : kExitSomethingLeft;
}

}  // namespace handwheel
